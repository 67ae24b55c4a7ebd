#!/bin/bash
# test_golden.sh -- gcc and clang, -O0 to -O3, with four and eight SIMD lanes give the same states,
# which equal the golden hashes.
# BUILD is the folder that make uses. Speaks TAP. If a hash differs, the output gives the first
# second.
set -u
variants=${BUILD:-build}/variants
golden=tests/replay/golden.txt
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
count=0

# The programs run in parallel, because the unoptimised ones are slow.
for program in "$variants"/*/state_hash; do
    name=$(basename "$(dirname "$program")")
    echo "$name 4"
    echo "$name 8"
done | xargs -P "$(nproc)" -L1 sh -c \
    '"$1/$3/state_hash" "$4" >"$2/$3-$4" 2>"$2/$3-$4.err" || echo "exit $?" >>"$2/$3-$4.err"' sh "$variants" "$out"

same() { # NAME EXPECTED TEXT: Test TEXT: the hashes of variant NAME equal the file EXPECTED.
    count=$((count + 1))
    if [ "$(cat "$out/$1.err")" = 'exit 77' ]; then
        echo "ok $count - $3 # SKIP this machine has no eight lanes"
        return
    fi
    if [ ! -s "$out/$1.err" ] && cmp -s "$out/$1" "$2"; then
        echo "ok $count - $3"
        return
    fi
    echo "not ok $count - $3"
    head -5 "$out/$1.err" | sed 's/^/# /'
    diff "$2" "$out/$1" | head -3 | sed 's/^/# /'
}

same gcc-O2-4 "$golden" 'half a minute of play gives the golden hashes (if not, see make golden)'
same gcc-O2-8 "$out/gcc-O2-4" 'eight lanes give the same states as four lanes'
for variant in gcc-O0 gcc-O3 clang-O0 clang-O2 clang-O3; do
    same $variant-4 "$out/gcc-O2-4" "$variant gives the states of gcc-O2 in every second"
    same $variant-8 "$out/gcc-O2-4" "$variant with eight lanes gives the states of gcc-O2 in every second"
done
sanitized='the address and undefined-behaviour sanitizers report nothing'
same sanitized-4 "$out/gcc-O2-4" "$sanitized"
same sanitized-8 "$out/gcc-O2-4" "$sanitized with eight lanes"
echo "1..$count"
