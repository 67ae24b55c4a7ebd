#!/bin/bash
# bench_assertions.sh WITH WITHOUT -- prints by how much the assertions raise the number of
# instructions of a tick. WITH and WITHOUT are bench_tank with and without assertions. Instruction
# counts do not depend on other programs on the machine. Exits 1 if the share reaches 2 %.
set -eu
command -v valgrind >/dev/null || { echo 'bench_assertions.sh: install valgrind (board/setup.sh dev)' >&2; exit 69; }
out=$(mktemp)
trap 'rm -f "$out"' EXIT
count() { # PROGRAM FISH
    valgrind -q --tool=callgrind --callgrind-out-file="$out" --toggle-collect=tank_tick "$1" "$2" 64 >/dev/null 2>&1
    awk '/^(summary|totals):/ { sum = $2 } END { print sum }' "$out"
}
for fish in 600 6000; do
    awk -v fish=$fish -v with="$(count "$1" $fish)" -v without="$(count "$2" $fish)" 'BEGIN {
        share = 100 * (with / without - 1)
        printf "%d fish: %d instructions with assertions, %d without: %+.2f %%\n", fish, with, without, share
        exit share >= 2 }'
done
