#!/usr/bin/env python3
"""filter.py FILE -- prints a header with its plain comments in the form that Doxygen reads.

The first comment documents the file. A comment on lines of its own documents what follows, and a
comment behind code documents that code. Section rules stay as they are. Characters that Doxygen
would take for commands or tags are escaped, and a range `1 .. 5` reads `1 to 5`."""
import re
import sys

COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|/\*.*?\*/', re.S)


def escape(text):
    text = re.sub(r'([\\@<>#&$])', r'\\\1', text).replace('%', '%%')
    return re.sub(r'(?<!\S)\.\.(?!\S)', 'to', text)  # Doxygen parses a lone `..` as the end of a list.


def convert(text):
    is_first = True

    def replace(match):
        nonlocal is_first
        comment = match.group(0)
        if not comment.startswith('/*') or comment.startswith('/* ----'):
            return comment
        body = escape(comment[2:-2])
        line = text[text.rfind('\n', 0, match.start()) + 1:match.start()]
        if is_first:
            is_first = False
            return '/** @file\n *' + body + '*/'
        return ('/**<' if line.strip() else '/**') + body + '*/'

    return COMMENT.sub(replace, text)


if __name__ == '__main__':
    with open(sys.argv[1], encoding='utf-8') as file:
        sys.stdout.write(convert(file.read()))
