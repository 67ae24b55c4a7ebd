#!/bin/bash
# test_golden.sh -- gcc and clang, -O0 to -O3, give the same states, and those are the known good.
#
# BUILD is the folder that make uses. Speaks TAP; where a hash differs it names the first second.
set -u
variants=${BUILD:-build}/variants
golden=tests/replay/golden.txt
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
count=0

# Side by side: the unoptimised ones are slow.
for program in "$variants"/*/state_hash; do
    name=$(basename "$(dirname "$program")")
    echo "$name"
done | xargs -P "$(nproc)" -I{} sh -c "$variants/{}/state_hash >$out/{} 2>$out/{}.err || echo \"exit \$?\" >>$out/{}.err"

same() { # NAME EXPECTED TEXT
    count=$((count + 1))
    if [ ! -s "$out/$1.err" ] && cmp -s "$out/$1" "$2"; then
        echo "ok $count - $3"
        return
    fi
    echo "not ok $count - $3"
    head -5 "$out/$1.err" | sed 's/^/# /'
    diff "$2" "$out/$1" | head -3 | sed 's/^/# /'
}

same gcc-O2 "$golden" 'half a minute of play gives the golden hashes (else see make golden)'
for variant in gcc-O0 gcc-O3 clang-O0 clang-O2 clang-O3; do
    same $variant "$out/gcc-O2" "$variant agrees with gcc-O2 on every second"
done
same sanitized "$out/gcc-O2" 'nothing undefined happens: address and undefined-behaviour sanitizers are silent'
echo "1..$count"
