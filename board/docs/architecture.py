#!/usr/bin/env python3
"""architecture.py [--check] BUILD SVG   draws the folders of the C code and their includes with Graphviz

The compiler's dependency files below BUILD list every file that a source pulls in. A box is a folder of the second
level with its subfolders; the number is its number of files. The files directly below core/ and platform/ are two
boxes: the contracts are the headers that include no box of their own folder except those of LOWEST.
An arrow from A to B says that a file of A includes a file of B. An arrow is left out if other arrows lead from A to
B, so that the picture shows the order of the layers. Red arrows belong to boxes that include each other.

The SVG holds the graph as a comment. --check compares that comment with the code, because versions of Graphviz place
the same graph differently. The exit status is 1 if the picture is out of date, and 2 if the tree is not built.
"""
import argparse
import collections
import os
import re
import subprocess
import sys

TOPS = ('core', 'drivers', 'platform', 'board')
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.M)
# Boxes whose headers a contract may include: mathematics, species tables, and the operating-system layer.
LOWEST = {'base', 'morph', 'os'}
FILL = {'core': '#fde7c8', 'drivers': '#dcefd8', 'platform': '#d8e6f5', 'board': '#eadcf0'}


def fail(status, text):
    print(f'architecture: {text}', file=sys.stderr)
    sys.exit(status)


def compiled_files(build):
    """Every file of the tree that the compiler read, by the dependency files of the last build."""
    files = set()
    for folder, _, names in os.walk(build):
        for name in names:
            if name.endswith('.d') and os.path.relpath(folder, build).split('/')[0] in TOPS:
                with open(os.path.join(folder, name), errors='replace') as file:
                    files |= {os.path.normpath(word) for word in file.read().replace('\\\n', ' ').split()[1:]}
    return {path for path in files if path.split('/')[0] in TOPS and path.endswith(('.c', '.h')) and os.path.exists(path)}


def whole_tree():
    for top in TOPS:
        for folder, _, names in os.walk(top):
            yield from (f'{folder}/{name}' for name in names if name.endswith(('.c', '.h')))


def direct_includes(files):
    includes = {}
    for path in files:
        with open(path, encoding='utf-8') as file:
            names = INCLUDE.findall(file.read())
        here = os.path.dirname(path)
        both = [(os.path.normpath(name), os.path.normpath(os.path.join(here, name))) for name in names]
        includes[path] = {name if name in files else near for name, near in both} & files
    return includes


def is_contract(includes, path):
    """Whether a header directly below a top folder includes nothing of that folder but such headers and LOWEST."""
    top = path.split('/')[0]
    seen, left = {path}, [path]
    while left:
        fresh = includes[left.pop()] - seen
        seen |= fresh
        left += fresh
    boxes = {name.split('/')[1] for name in seen if name.startswith(top + '/') and name.count('/') > 1}
    return path.endswith('.h') and boxes <= LOWEST


def box_of(includes, path):
    parts = path.split('/')
    if len(parts) > 2:
        return '/'.join(parts[:2])
    if parts[0] in ('core', 'platform'):
        return parts[0] + '/' + ('contracts' if is_contract(includes, path) else './')
    return parts[0] + '/./'


def read_graph(build):
    """The number of files of each box with the names of its subfolders, and the pairs of boxes with an include."""
    files = compiled_files(build)
    if not files:
        fail(2, f'{build} has no dependency files; run `make` first')
    includes = direct_includes(files)
    boxes = {path: box_of(includes, path) for path in files}
    counts, folders = collections.Counter(), collections.defaultdict(set)
    for path in whole_tree():  # Another version of a library compiles other files, but the numbers stay equal.
        box = boxes.get(path) or box_of(includes | {path: set()}, path)
        counts[box] += 1
        folders[box] |= set(path.split('/')[2:-1])
    edges = {(boxes[path], boxes[name]) for path in files for name in includes[path]}
    return counts, folders, {edge for edge in edges if edge[0] != edge[1]}


def reachable(edges, start, without=None):
    """Folders to which arrows lead from `start`, if the arrow `without` is removed."""
    found, left = set(), [start]
    while left:
        here = left.pop()
        for source, target in edges:
            if source == here and (source, target) != without and target not in found:
                found.add(target)
                left.append(target)
    return found


def reduce(edges):
    """Removes each arrow that other arrows replace. An arrow inside a cycle stays."""
    kept = set(edges)
    for edge in sorted(edges):
        in_cycle = edge[0] in reachable(edges, edge[1])
        if not in_cycle and edge[1] in reachable(kept, edge[0], edge):
            kept.discard(edge)
    return kept


def draw(counts, folders, edges):
    lines = ['digraph architecture {', '  rankdir=TB; ranksep=0.45; nodesep=0.18; bgcolor=white;',
             '  node [shape=box, style="rounded,filled", color="#666666", fontname="sans-serif", fontsize=12,',
             '        margin="0.10,0.05", height=0.3];', '  edge [color="#777777", arrowsize=0.6];']
    for top in TOPS:
        lines.append(f'  subgraph cluster_{top} {{ label="{top}/"; fontname="sans-serif"; fontsize=15; '
                     'color="#bbbbbb"; style=rounded;')
        for box in sorted(counts):
            if box.split('/')[0] == top:
                below = f'\\n{", ".join(sorted(folders[box]))}' if folders[box] else ''
                name = box.partition('/')[2]
                lines.append(f'    "{box}" [label="{name}  {counts[box]}{below}", fillcolor="{FILL[top]}"];')
        lines.append('  }')
    for source, target in sorted(reduce(edges)):
        mutual = source in reachable(edges, target)
        lines.append(f'  "{source}" -> "{target}"' + (' [color="#cc3333"];' if mutual else ';'))
    return '\n'.join(lines + ['}'])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--check', action='store_true')
    parser.add_argument('build')
    parser.add_argument('svg')
    options = parser.parse_args()
    graph = draw(*read_graph(os.path.normpath(options.build)))
    comment = '<!--\n' + graph + '\n-->\n'
    if options.check:
        with open(options.svg, encoding='utf-8') as file:
            if comment not in file.read():
                fail(1, f'{options.svg} is out of date; run `make architecture` and commit the picture')
        return
    made = subprocess.run(['dot', '-Tsvg'], input=graph, capture_output=True, text=True)
    if made.returncode != 0:
        fail(2, f'dot failed: {made.stderr.strip()}')
    picture = re.sub(r'<!--.*?-->\n', '', made.stdout, flags=re.S)  # The comments repeat the node names that the titles contain.
    with open(options.svg, 'w', encoding='utf-8') as file:
        file.write(picture.replace('<svg ', comment + '<svg ', 1))


if __name__ == '__main__':
    main()
