#!/bin/bash
# bench_tank.sh BUILD -- measures the times of the tank, and the instructions that valgrind counts.
# Prints tables and writes BUILD/bench_tank.tsv. Needs a quiet machine and takes two minutes.
build=$1
bench=$build/tests/bench/bench_tank
tsv=$build/bench_tank.tsv
"$bench" "$tsv" || exit $?

"$build/tests/sizes" | awk -v tsv="$tsv" '
    $1 == "tank" { printf "\nMemory: %d bytes for 2,048 fish and their water, %.0f a fish.\n", $2, $2 / 2048
                   printf "bytes_per_fish\ttank\t2048\t0\t%.1f\n", $2 / 2048 >> tsv }'

if ! command -v valgrind >/dev/null; then
    echo 'Instructions: not counted, valgrind is not installed.'
    exit 0
fi
count() { # FISH TICKS
    valgrind --tool=callgrind --callgrind-out-file="$build/callgrind.out" --toggle-collect=tank_tick \
        "$bench" "$1" "$2" >/dev/null 2>"$build/callgrind.log" || { cat "$build/callgrind.log"; return 1; }
    awk -v fish="$1" -v ticks="$2" -v tsv="$tsv" '
        /^(summary|totals):/ { sum = $2 }
        END { printf "Instructions a fish and tick at %d fish: %.0f (callgrind, 8 lanes where the processor has them).\n",
                  fish, sum / fish / ticks
              printf "instructions\tkingyo\t%d\t0\t%.0f\n", fish, sum / fish / ticks >> tsv }' "$build/callgrind.out"
}
count 600 64 && count 6000 64
