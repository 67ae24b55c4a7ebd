#!/usr/bin/env python3
"""metrics.py [--root DIR] [--top N] [--build DIR]   measures the structure and the comments of the C code
metrics.py [--root DIR] sample FOLDER COUNT SEED  prints random comments of a folder for a reader to score

The first form prints one row for each measure: its value, its bound, and `ok` or `MISS`. Below the table, each
missed measure is followed by its worst places (15, or N). The exit status is 1 if a bound is missed, and 2 if a
tool is missing.

Files are found by walking the top folders, so that the tree below them may be rearranged. "Production" means the
.c and .h files below core, drivers, platform, board and assets. Tests count only where the row names them.

How each measure is defined:
  comment sentence   A comment of at least three words is split after `.`, `;` or `:`; parts of at least three
                     words count. The two word lists BARE and IDIOM below decide, and new words can be added there.
  code lines         The count of cloc, without comments and blank lines. CODE_LINES_MAX is the bound of the tree
                     before the features of FEATURE_LINES, which had 77,977 lines. The bound of today's tree also
                     contains the lines of each of these features.
  small files        Production files under SMALL_LINES code lines that small_files.tsv does not list with a reason, and
                     lines of that table that name no such file. A small header needs no line if a source with the
                     same path exists, or if at least two files include the header.
  flat folder        The number of .c and .h files that lie directly in one folder. Folders of tests count too.
  functions          Definitions that universal-ctags finds, per 1,000 lines including comments and blank lines.
  one caller         A static function whose name is used at exactly one place of its file, apart from its own
                     definition, declarations and recursive calls, and that place is a call. A function whose
                     address is only stored in a table has no caller, because the table replaces the call.
  assertions         Uses of assert() and of macros whose name ends in ASSERT; _Static_assert does not count.
  header comments    Lines of headers that hold a comment, also behind code, divided by all lines, blank lines included.
                     The same measure gave 36 % for the tree before, and 46 % for littlefs.
  cycle              A module is a header and the source of the same path. An edge is an #include. The measure is
                     the number of modules in the largest strongly connected component. If --build names a folder
                     of dependency files (.d), each file's includes are compared with the compiler's own list.
  mutable state      Functions below core/game with a parameter `struct core *` or `struct game *` that is not const.
  static names       Names of static functions of .c files that occur as an identifier in more than three files,
                     because a search for such a name leads to the wrong places.
  module's name      An external function is named after its module if its name is, or begins with, the first word
                     of its file's name or the name of a folder above the file (with or without a plural s).
                     PREFIXES has the short prefixes of the mathematics modules. main(), the names in ENTRY_POINTS
                     and names in capital letters, which a macro replaces, are free.
  files to open      The files of a path in paths.txt. Each of its lines names a file and an identifier on the path;
                     a line whose file or identifier no longer exists is an error.
  formatting         The replacements that clang-format-19 proposes for the committed .clang-format.
"""
import argparse
import collections
import os
import random
import re
import subprocess
import sys

PRODUCTION = ('core', 'drivers', 'platform', 'board', 'assets')
ALL = PRODUCTION + ('tests',)
FORMATTER = 'clang-format-19'

SMALL_LINES = 60
CODE_LINES_MAX = 78000
# Features that came after the bound, with the code lines that cloc counts in the commit of each.
FEATURE_LINES = {
    'the cause of a tear, with slow motion': 456,
    'levels by a tag with a picture': 426,
    'a fish as a present': 120,
    'a lifted fish that thrashes, and water that runs off the paper': 45,
    'lessons: a ring around an easy fish, and an arrow to the bowl': 258,
    'lessons: a ghost hand, and hints beside the poi': 505,
    'caught fish that fly to the counter, and the word for a near miss': 193,
    'bodies of players: settings in the menu, arrows beside a value, and the side of the bowl': 158,
    'a click to dip, the reach of pointers, and a number on each handle': 69,
    'the fall of a present into its bowl': 14,
    'a signal stack for the audio thread of SDL': 7,
    'the end of a session between two games, and the tick at which a file of a panic ends': 31,
    'the memory card, and the supply, heat, HDMI socket and overlay of a Raspberry Pi in doctor': 232,
    'a bound for the rewritten part of the write-ahead log': 24,
    'pictures that are drawn once, or at low resolution (shades, reflections, counter, fan)': 156,
    'shapes of fish that are blended once and kept in a texture, and the strips at the edge of the water': 35,
    'light for each vertex of poi and bowl, colours for each fish, a mesh for small fish, cropped pictures': 420,
    'quality steps in the order in which a viewer notices them, the screen scale, and half the frame rate': 68,
    'bowls before the water for the early depth test, shades of fans only where they fall, grids in bands': 74,
    'an artificial scene that draws with every program while the game loads': 93,
    'a camera on the short side of the tank, handles of bots, and axes of the player': 126,
    'a Latin typeface of the readable text, a curtain that cuts no letter, and a pointer without paper': 34,
    'a backup of a database that was deleted while it was open, and the links and FIFOs that doctor names': 54,
    'festival music, sounds around the stall, and a mixer': 1386,
    'effects that follow their cause: wetting, drips, gulps, escapes and the outcome of a round': 31,
    'quiet sounds of water and fish that give way, and plain skins of goldfish': 18,
    'credits that wait until the log is on disk, renames that replace no file, a backup that is aborted, a complete read of the settings': 90,
    'the update by USB stick: its page in the menu, and the link to the service': 383,
    'the self-test of a board with its report, and a supply voltage that no driver measures in doctor': 156,
    'a replay as a video with sound, by ffmpeg or as pictures and a WAV file': 394,
    'black goldfish, and kinds of fish by their frequency': 8,
    'volumes of music and effects, quiet hours, and the light in the menu': 61,
    'a hand with a sleeve that holds each poi': 412,
    'a left hand, and a hand of 400 triangles whose fingers are one surface': 99,
    'splashes that state their water, apart from the sounds of fish': 8,
    'narrow highlights on near fish, and ribbons beside the arm of the demonstration': 5,
    'drops of splashes, and their rings on the water': 191,
    'a wave and more drops where a fish falls into a bowl': 8,
    'weights of the colours of a fish at each vertex': 20,
    'flaps and scraps of torn paper': 103,
    'holes of the paper that open from a slit': 31,
    'demekin and ryukin: double tails in species texts, and varieties that are only drawn': 48,
    'light of a summer night, in the shaders and on each fish, and daylight by a setting': 64,
    'the street behind the stall, by night and by day, and the wet wood around the tank': 380,
    'reflections in the water of bowls, and shadows of the fish in bowls': 26,
    'the hose of the air stone': 8,
    'checks of results and of a divisor that clang-tidy needs': 5,
    'programs that are drawn once before their first use, shadows in bowls, a camera at rest, coins that no store accepted': 64,
    'hands of bots and the bowl on portrait screens, and a new system that is kept only with a picture': 48,
    'a camera that drifts in attract mode, and pictures below the water that follow it': 108,
    'a camera that comes closer in a round with one player, its setting, and calm changes of render targets': 133,
    'classic white bowls, and a lip without gaps': 29,
    'sounds that come from their side of the picture, also on a portrait screen': 24,
    'ornaments of the flute in the scale of the tune, and random pitches of sounds that follow each other': 27,
    'a tear that grows and is heard in its full strength': 12,
    'rim and counter from a kept picture while the camera moves, on each orientation and width of a screen': 88,
    'passers-by with sandals, strips of water that a near camera hides, and soft streaks of lanterns': 57,
    'hues of goldfish from deep red to gold, washed skin, and strong light on fish that is attenuated': 25,
    'a paper tag that flies to the counter for each caught fish': 15,
    'errors of a memory card by its host, bits of the supply that cannot be read, and the supply before the vents': 22,
    'refraction that joins the parts of a poi in water and air': 38,
    'flaps of torn paper from the distance to the edge of a hole, the wave and the drops of a poi at the surface': 116,
    'fingers of their own, a picture of the skin, and a sleeve that hangs open': 106,
    'an arm beside the bowl and heads below the panels on a portrait screen': 18,
    'an outline that ends in the margin of a letter': 1,
    'a hand that holds the fan, whose face is opaque': 69,
    'fingers that are cut at their circle, light without an edge at the knuckles, and a pattern of hemp leaves': 52,
}

# A sentence that begins with one of these words leaves its subject to the reader.
BARE = """who|whoever|whose|whom|what|whatever|which|of|one|it|its|they|them|that|those|this|none|nobody|as|then|
    in so"""

# Idiom and personification. Each entry is a word or a phrase that is matched as whole words.
IDIOM = """whoever|nobody|somebody|whose turn|who is|what is|spared?|heeds?|heeded|tells?|told|believes?|
    believed|knows|knew|know|wants?|wanted|asks?|asked|says?|said|looks?|looked|hears?|heard|minds|owes?|owed|
    purses?|put away|puts away|let go|lets go|goes on|go on|goes home|go home|by itself|the hand|a hand|hands|
    whence|thereby|anew|in vain|moods?|politely|strangers?"""

# Modules whose functions are used in every formula have a short prefix, as mathematics libraries do.
PREFIXES = {'core/base/fmath': {'f'}, 'core/base/vec': {'v3'}}

# External names that a linker, a C library, a fuzzer or the core demands (each program defines core_panic).
ENTRY_POINTS = {'main', 'core_panic', 'LLVMFuzzerTestOneInput', 'LLVMFuzzerInitialize', 'memcpy', 'memmove', 'memset', 'memcmp'}


def whole_words(listed):
    return r'(?:%s)\b' % '|'.join(' '.join(entry.split()) for entry in listed.split('|'))


BARE_RE = re.compile(whole_words(BARE), re.I)
IDIOM_RE = re.compile(r'\b' + whole_words(IDIOM), re.I)
LEX_RE = re.compile(r'/\*.*?(?:\*/|\Z)|//(?:[^\n\\]|\\.)*|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'', re.S)
WORD_RE = re.compile(r'[A-Za-z_]\w*')
INCLUDE_RE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.M)
ASSERT_RE = re.compile(r'\b(?:assert|\w*ASSERT)\s*\(')


def fail(text):
    print(f'metrics: {text}', file=sys.stderr)
    sys.exit(2)


def run_tool(command, root, text=None, allowed=(0,)):
    try:
        result = subprocess.run(command, cwd=root, input=text, capture_output=True, text=True, errors='replace')
    except FileNotFoundError:
        fail(f'{command[0]} is not installed; board/setup.sh dev installs it')
    if result.returncode not in allowed:
        fail(f'{command[0]} failed: {result.stderr.strip()[:300]}')
    return result


def find_files(root, tops):
    found = []
    for top in tops:
        for folder, subfolders, names in os.walk(os.path.join(root, top)):
            subfolders[:] = sorted(s for s in subfolders if not s.startswith(('.', 'build')) and s != 'node_modules')
            found += [os.path.relpath(os.path.join(folder, n), root) for n in sorted(names) if n.endswith(('.c', '.h'))]
    return found


class Comment:
    def __init__(self, first, last, words):
        self.first, self.last, self.words = first, last, words  # Lines from 1; the text as one line.


class Source:
    """One file: its text, its comments, and its code with comments and literals blanked."""

    def __init__(self, root, path):
        with open(os.path.join(root, path), encoding='utf-8', errors='replace') as file:
            self.text = file.read()
        self.path = path
        self.lines = self.text.split('\n')
        if self.lines[-1] == '':
            self.lines.pop()
        self.comments = []
        self.functions = []
        self.code = LEX_RE.sub(self._blank, self.text)
        self.code_lines = self.code.split('\n')

    def _blank(self, match):
        text = match.group(0)
        if not text.startswith('/'):
            return text[0] + ' ' * (len(text) - 2) + text[-1]
        first = self.text.count('\n', 0, match.start()) + 1
        words = []
        for line in re.sub(r'\A/[*/]+|\*+/\Z', '', text).split('\n'):
            words += re.sub(r'\A\s*\*+(?=\s|\Z)', '', line).split()
        last = first + text.count('\n')
        above = self.comments[-1] if self.comments else None
        alone = not self.text[self.text.rfind('\n', 0, match.start()) + 1:match.start()].strip()
        if text.startswith('//') and above and above.last == first - 1 and alone and above.slashes:
            above.last, above.words = last, above.words + ' ' + ' '.join(words)  # One comment of several // lines.
        else:
            self.comments.append(Comment(first, last, ' '.join(words)))
            self.comments[-1].slashes = text.startswith('//')
        return re.sub(r'[^\n]', ' ', text)

    def sentences(self):
        for comment in self.comments:
            if len(comment.words.split()) >= 3:
                for sentence in re.split(r'(?<=[.;:])\s+', comment.words):
                    if len(sentence.split()) >= 3:
                        yield comment.first, sentence


class Function:
    def __init__(self, name, path, first, last, signature, static):
        self.name, self.path, self.first, self.last = name, path, first, last
        self.signature, self.static = signature, static


def is_bare(sentence):
    return sentence.startswith('...') or BARE_RE.match(sentence)


def is_idiom(sentence):
    return IDIOM_RE.search(sentence)


def find_functions(root, sources):
    form = '%{name}\t%{input}\t%{line}\t%{end}\t%{signature}'
    command = ['ctags', '--options=NONE', '-x', '--languages=C', '--langmap=C:.c.h', '--kinds-C=f', '--sort=no',
               '--fields=+neS', '--_xformat=' + form, '-L', '-']
    for line in run_tool(command, root, '\n'.join(sources)).stdout.splitlines():
        parts = line.split('\t')
        if len(parts) < 5 or not parts[2].isdigit():
            continue
        name, path, first = parts[0], parts[1], int(parts[2])
        source = sources[path]
        last = int(parts[3]) if parts[3].isdigit() else first
        before = '\n'.join(source.code_lines[max(0, first - 6):first])
        before = before[:before.rfind(name)]
        head = re.split(r'[;}]|^[ \t]*#.*$', before, flags=re.M)[-1]
        static = re.search(r'\bstatic\b', head) is not None
        source.functions.append(Function(name, path, first, last, parts[4], static))
    return [f for s in sources.values() for f in s.functions]


def count_uses(source):
    """Places where each static function of the file is used, apart from its definition and declarations.

    The second counter has those of the places that are no call, such as an entry of a table."""
    static = {f.name: f for f in source.functions if f.static}
    uses, stored = collections.Counter(), collections.Counter()
    for match in WORD_RE.finditer(source.code) if static else ():
        function = static.get(match.group(0))
        if function:
            line = source.code.count('\n', 0, match.start()) + 1
            if not function.first <= line <= function.last:
                uses[function.name] += 1
                stored[function.name] += not source.code[match.end():match.end() + 40].lstrip().startswith('(')
    for name in static:
        uses[name] -= len(re.findall(r'^static\b[^;{}()=]*\b%s\s*\([^;{}]*\)\s*;' % name, source.code, re.M))
    return uses, stored, static


def largest_cycles(edges):
    """Strongly connected components of more than one node, the largest first (Tarjan's algorithm)."""
    number, low, on_stack, stack, found = {}, {}, set(), [], []
    for start in sorted(edges):
        if start in number:
            continue
        work = [(start, iter(sorted(edges[start])))]
        number[start] = low[start] = len(number)
        stack.append(start)
        on_stack.add(start)
        while work:
            node, following = work[-1]
            for other in following:
                if other not in number:
                    number[other] = low[other] = len(number)
                    stack.append(other)
                    on_stack.add(other)
                    work.append((other, iter(sorted(edges[other]))))
                    break
                if other in on_stack:
                    low[node] = min(low[node], number[other])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == number[node]:
                    component = []
                    while not component or component[-1] != node:
                        component.append(stack.pop())
                        on_stack.discard(component[-1])
                    if len(component) > 1:
                        found.append(sorted(component))
    return sorted(found, key=lambda c: (-len(c), c))


def find_includes(sources):
    """For each file, the files of the tree that it includes by name: from the root, or beside itself."""
    direct = {}
    for path, source in sources.items():
        direct[path] = set()
        for match in INCLUDE_RE.finditer(source.text):
            if source.code[match.start():match.end()].strip().startswith('#'):
                for name in (match.group(1), os.path.normpath(os.path.join(os.path.dirname(path), match.group(1)))):
                    if name in sources:
                        direct[path].add(name)
                        break
    return direct


def closure(direct, path):
    seen, work = set(), [path]
    while work:
        for other in direct.get(work.pop(), ()):
            if other not in seen:
                seen.add(other)
                work.append(other)
    return seen


def compare_with_compiler(root, build, direct, sources):
    """Returns how many dependency files were read, and the includes that only the compiler lists."""
    count, other = 0, []
    base = os.path.join(root, build)
    for folder, _, names in os.walk(base):
        for name in (n for n in names if n.endswith('.d')):
            with open(os.path.join(folder, name), errors='replace') as file:
                rule = file.read().replace('\\\n', ' ').split('\n')[0]
            wanted = [os.path.normpath(w) for w in rule.partition(':')[2].split()]
            path = next((w for w in wanted if w in sources and w.endswith('.c')), None)
            if path and os.path.getmtime(os.path.join(folder, name)) >= os.path.getmtime(os.path.join(root, path)):
                count += 1
                own = closure(direct, path)
                for made in (w for w in wanted if w.startswith(build + '/') and w.endswith('.h')):
                    with open(os.path.join(root, made), errors='replace') as file:  # A generated header.
                        for name in INCLUDE_RE.findall(file.read()):
                            own |= {name} | closure(direct, name)
                other += [f'{path}: {w}' for w in wanted if w in sources and w != path and w not in own]
    return count, other


def first_words(path):
    """Prefixes that an external function of this file may have."""
    folders = os.path.dirname(path).split('/')
    stem = os.path.splitext(os.path.basename(path))[0]
    words = {stem.split('_')[0].split('-')[0], stem}
    for folder in folders:
        word = folder.replace('-', '_')
        words |= {word, word[:-1] if word.endswith('s') else word}
    return words


def has_module_name(function):
    words = first_words(function.path) | PREFIXES.get(os.path.splitext(function.path)[0], set())
    return function.name.isupper() or any(function.name == w or function.name.startswith(w + '_') for w in words)


def read_paths(root, sources):
    """The files of each path in paths.txt, and the lines that no longer hold."""
    paths, stale = collections.defaultdict(list), []
    name = 'tests/metrics/paths.txt'
    if not os.path.exists(os.path.join(root, name)):
        return paths, [f'{name} is missing']
    with open(os.path.join(root, name), encoding='utf-8') as file:
        for number, line in enumerate(file, 1):
            words = line.split()
            if not words or line.startswith('#'):
                continue
            if len(words) != 3:
                stale.append(f'{name}:{number}: expected PATH FILE IDENTIFIER')
            elif words[1] not in sources:
                stale.append(f'{name}:{number}: {words[1]} does not exist')
            elif not re.search(r'\b%s\b' % re.escape(words[2]), sources[words[1]].code):
                stale.append(f'{name}:{number}: {words[1]} has no {words[2]}')
            if len(words) == 3 and words[1] not in paths[words[0]]:
                paths[words[0]].append(words[1])
    return paths, stale


def count_code_lines(root, paths):
    listed = run_tool(['cloc', '--quiet', '--csv', '--by-file', '--skip-uniqueness', '--list-file=-'], root,
                      '\n'.join(paths)).stdout
    lines = {}
    for line in listed.splitlines():
        parts = line.split(',')
        if len(parts) >= 5 and parts[4].isdigit() and parts[1] != '':
            lines[os.path.normpath(parts[1])] = int(parts[4])
    return {p: lines.get(p, 0) for p in paths}


def count_formatting(root, paths):
    """Replacements that the formatter proposes, by file; None without a committed .clang-format."""
    if not os.path.exists(os.path.join(root, '.clang-format')):
        return collections.Counter()
    found = collections.Counter()
    for start in range(0, len(paths), 100):
        result = run_tool([FORMATTER, '--dry-run', '--ferror-limit=0'] + paths[start:start + 100], root)
        for match in re.finditer(r'^([^:\n]+):\d+:\d+: warning: code should be clang-formatted', result.stderr, re.M):
            found[os.path.normpath(match.group(1))] += 1
    return found


def folder_of(path):
    return os.path.dirname(path)


def ranked(counter, form='{:6} {}'):
    return [form.format(n, what) for what, n in sorted(counter.items(), key=lambda x: (-x[1], x[0])) if n]


class Table:
    def __init__(self):
        self.rows = []

    def add(self, measure, value, bound, worst, form='{:.0f}'):
        """A bound is (low, high), either of which may be None. `worst` lists places, the worst first."""
        low, high = bound
        good = (low is None or value >= low) and (high is None or value <= high)
        number = form.format
        text = (f'{number(low)} to {number(high)}' if None not in bound
                else f'>= {number(low)}' if high is None else f'<= {number(high)}')
        self.rows.append((measure, number(value), text, good, worst))

    def show(self, top):
        print(f'{"measure":58} {"value":>9}  {"bound":18} result')
        for measure, value, bound, good, _ in self.rows:
            print(f'{measure:58} {value:>9}  {bound:18} {"ok" if good else "MISS"}')
        for measure, value, bound, good, worst in self.rows:
            if not good:
                print(f'\nMISS: {measure}: {value}, bound {bound}')
                for line in worst[:top]:
                    print(f'  {line}')
                if len(worst) > top:
                    print(f'  .. and {len(worst) - top} more')
        return all(row[3] for row in self.rows)


def measure_comments(table, product):
    counts = collections.Counter()
    worst = {'bare': collections.Counter(), 'idiom': collections.Counter()}
    first = {}
    for source in product.values():
        for line, sentence in source.sentences():
            counts['all'] += 1
            for kind, test in (('bare', is_bare), ('idiom', is_idiom)):
                if test(sentence):
                    counts[kind] += 1
                    worst[kind][source.path] += 1
                    first.setdefault((kind, source.path), f'line {line}: {sentence[:60]}')
    for kind, high, what in (('bare', 5.0, 'comment sentences that begin with a bare pronoun'),
                             ('idiom', 1.5, 'comment sentences with idiom or personification')):
        lines = [f'{n:4} {p}  {first[kind, p]}' for p, n in sorted(worst[kind].items(), key=lambda x: (-x[1], x[0]))]
        table.add(what, 100 * counts[kind] / max(1, counts['all']), (None, high), lines, '{:.1f} %')


def check_small_files(root, product, code):
    """Small files that the table does not list, and lines of the table that name no small file."""
    name, listed, wrong = 'tests/metrics/small_files.tsv', set(), []
    included = collections.Counter(o for others in find_includes(product).values() for o in others)
    small = {p for p in product if code[p] < SMALL_LINES}
    if os.path.exists(os.path.join(root, name)):
        with open(os.path.join(root, name), encoding='utf-8') as file:
            for number, line in enumerate(file, 1):
                path, _, reason = line.rstrip('\n').partition('\t')
                if not line.startswith('#'):
                    listed.add(path)
                    if path not in small or not reason.strip():
                        wrong.append(f'{name}:{number}: {path} is no file under {SMALL_LINES} lines, or has no reason')
    for path in sorted(small - listed):
        if path.endswith('.c') or (path[:-1] + 'c' not in product and included[path] < 2):
            wrong.append(f'{path}: {code[path]} lines; merge the file or enter it with its reason in {name}')
    return wrong


def measure_size(table, root, product, everything):
    code = count_code_lines(root, list(product))
    by_folder = collections.Counter()
    for path, n in code.items():
        by_folder[folder_of(path)] += n
    table.add('production code lines', sum(code.values()), (None, CODE_LINES_MAX + sum(FEATURE_LINES.values())),
              ranked(by_folder), '{:,.0f}')
    files = collections.Counter(folder_of(p) for p in product)
    total = sum(len(s.lines) for s in product.values())
    table.add('production files', len(product), (600, 700), ranked(files))
    short = collections.Counter(folder_of(p) for p, s in product.items() if len(s.lines) < 60)
    table.add('mean lines of a production file', total / max(1, len(product)), (150, 250),
              ranked(short, '{:6} files under 60 lines in {}'), '{:.1f}')
    wrong = check_small_files(root, product, code)
    table.add('small files without a reason in small_files.tsv', len(wrong), (None, 0), wrong)
    flat = collections.Counter(folder_of(p) for p in everything)
    table.add('C files in the largest flat folder', max(flat.values(), default=0), (None, 33),
              ranked({f: n for f, n in flat.items() if n > 33}))
    return total


def measure_functions(table, product, functions, total):
    density = {}
    for source in product.values():
        if len(source.lines) >= 80:
            density[source.path] = round(1000 * len(source.functions) / len(source.lines))
    table.add('functions per 1,000 lines', 1000 * len(functions) / max(1, total), (None, 40), ranked(density), '{:.1f}')
    static, single = 0, collections.Counter()
    for source in product.values():
        uses, stored, names = count_uses(source)
        if source.path.endswith('.c'):
            static += len(names)
            single[source.path] += sum(uses[name] == 1 and not stored[name] for name in names)
    table.add('static functions with one caller', 100 * sum(single.values()) / max(1, static), (None, 45),
              ranked(single), '{:.1f} %')


def measure_assertions(table, product):
    for what, tops, low in (('core and drivers', ('core', 'drivers'), 0.5),
                            ('platform, board and assets', ('platform', 'board', 'assets'), 0.2)):
        functions, asserts, bare = 0, 0, collections.Counter()
        for source in product.values():
            if source.path.split('/')[0] in tops:
                code = re.sub(r'^[ \t]*#[ \t]*define.*$', '', source.code, flags=re.M)
                here = len(ASSERT_RE.findall(code))
                functions += len(source.functions)
                asserts += here
                bare[source.path] = max(0, len(source.functions) - here)
        table.add(f'assertions per function, {what}', asserts / max(1, functions), (low, None),
                  ranked(bare, '{:6} functions without one in {}'), '{:.2f}')


def measure_headers(table, product):
    comment, total, distance = 0, 0, {}
    for source in product.values():
        if source.path.endswith('.h'):
            marked = {n for c in source.comments for n in range(c.first, c.last + 1) if source.lines[n - 1].strip()}
            comment += len(marked)
            total += len(source.lines)
            distance[source.path] = len(marked) - round(0.455 * len(source.lines))
    share = 100 * comment / max(1, total)
    worst = {p: n if share > 45.5 else -n for p, n in distance.items() if (n > 0) == (share > 45.5)}
    table.add('comment share of headers', share, (43, 48),
              ranked(worst, '{:6} comment lines too ' + ('many' if share > 45.5 else 'few') + ' in {}'), '{:.1f} %')


def measure_cycles(table, root, build, sources, product):
    direct = find_includes(sources)
    edges = collections.defaultdict(set)
    for path in product:
        node = os.path.splitext(path)[0]
        edges[node] |= {os.path.splitext(o)[0] for o in direct[path] if o in product} - {node}
    for others in list(edges.values()):
        for other in others:
            edges[other] |= set()
    cycles = largest_cycles(edges)
    lines = []
    for cycle in cycles:
        lines.append(f'{len(cycle)} modules: {", ".join(cycle[:12])}{", .." if len(cycle) > 12 else ""}')
    table.add('modules in the largest include cycle', len(cycles[0]) if cycles else 1, (None, 5), lines)
    return compare_with_compiler(root, build, direct, sources)


def measure_names(table, product, functions):
    for name, high in (('core', 10), ('game', 35)):
        mutable = [f for f in functions if f.path.startswith('core/game/')
                   and re.search(r'(?<!const )\bstruct %s\s*\*' % name, f.signature)]
        table.add(f'functions in core/game that take a mutable struct {name} *', len(mutable), (None, high),
                  ranked(collections.Counter(f.path for f in mutable)))
    static = {f.name for f in functions if f.static and f.path.endswith('.c')}
    where = collections.defaultdict(list)
    for path, source in product.items():
        for name in static.intersection(WORD_RE.findall(source.code)):
            where[name].append(path)
    shared = {name: len(paths) for name, paths in where.items() if len(paths) > 3}
    table.add('static function names used in more than 3 files', len(shared), (None, 59),
              [f'{n:4} files use {name}  {", ".join(where[name][:3])}, ..'
               for name, n in sorted(shared.items(), key=lambda x: (-x[1], x[0]))])
    foreign = collections.defaultdict(list)
    for function in functions:
        if not function.static and function.name not in ENTRY_POINTS and not has_module_name(function):
            foreign[function.path].append(function.name)
    table.add("external functions without their module's name", sum(map(len, foreign.values())), (None, 0),
              [f'{len(n):4} {p}  {", ".join(n[:4])}' for p, n in sorted(foreign.items(), key=lambda x: (-len(x[1]), x))])


def measure_paths(table, root, sources):
    paths, stale = read_paths(root, sources)
    for name, high, what in (('poi', 28, 'files from a poi report on USB to the picture'),
                             ('coin', 24, 'files from a coin to the disk')):
        table.add(what, len(paths[name]), (1, high), ranked(collections.Counter(map(folder_of, paths[name]))))
    table.add('lines of paths.txt that no longer hold', len(stale), (None, 0), stale)


def measure(root, build, top):
    sources = {p: Source(root, p) for p in find_files(root, ALL)}
    product = {p: s for p, s in sources.items() if p.split('/')[0] in PRODUCTION}
    functions = find_functions(root, product)
    table = Table()
    measure_comments(table, product)
    total = measure_size(table, root, product, sources)
    measure_functions(table, product, functions, total)
    measure_assertions(table, product)
    measure_headers(table, product)
    compared, unknown = measure_cycles(table, root, build, sources, product)
    measure_names(table, product, functions)
    measure_paths(table, root, sources)
    differences = count_formatting(root, list(sources))
    for what, test in (('production', lambda p: p in product), ('tests', lambda p: p not in product)):
        here = {p: n for p, n in differences.items() if test(p)}
        table.add(f'differences from .clang-format, {what} ({len(here)} files)', sum(here.values()), (None, 0),
                  ranked(here), '{:,.0f}')
    good = table.show(top)
    if compared:
        print(f'\nIncludes agree with the compiler in {compared} dependency files'
              + (f', except {len(unknown)}:' if unknown else '.'))
        for line in unknown[:top]:
            print(f'  {line}')
    return good and not unknown


def print_sample(root, folder, count, seed):
    folder = os.path.normpath(folder)
    found = []
    for path in find_files(root, [folder]):
        source = Source(root, path)
        found += [(source, c) for c in source.comments if len(c.words.split()) >= 3]
    chosen = random.Random(seed).sample(found, min(count, len(found)))
    for number, (source, comment) in enumerate(chosen, 1):
        print(f'[{number}] {source.path}:{comment.first}\n  comment: {comment.words}')
        beside = source.code_lines[comment.first - 1]
        below = [beside] if beside.strip() else []
        for line in source.lines[comment.last:]:
            if len(below) >= 4 + bool(beside.strip()):
                break
            if line.strip():
                below.append(line)
        print('\n'.join(f'  | {line.rstrip()}' for line in below) + '\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--root', default=os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..'))
    parser.add_argument('--top', type=int, default=15)
    parser.add_argument('--build', default='build')
    parser.add_argument('words', nargs='*', metavar='sample FOLDER COUNT SEED')
    options = parser.parse_args()
    root = os.path.abspath(options.root)
    if not options.words:
        sys.exit(0 if measure(root, options.build, options.top) else 1)
    if len(options.words) != 4 or options.words[0] != 'sample':
        parser.error('expected nothing, or: sample FOLDER COUNT SEED')
    print_sample(root, options.words[1], int(options.words[2]), int(options.words[3]))


if __name__ == '__main__':
    main()
