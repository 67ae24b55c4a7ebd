#!/bin/bash
# test_growth_hash.sh -- gcc and clang, -O0 to -O3, four lanes and eight, grow every species into the same shapes,
# bit for bit; and nothing that the language leaves undefined happens on the way. That is said of one bake: the
# tables are drawn in double by the libm of the machine that builds, and another's may round a count otherwise.
#
# BUILD is the folder that make uses. Speaks TAP; where a hash differs it names the species.
set -u
variants=${BUILD:-build}/variants
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
count=0

same() { # VARIANT LANES
    count=$((count + 1))
    "$variants/$1/state_hash" "$2" growth >"$out/hashes" 2>"$out/err"
    local code=$? text="$1 with $2 lanes grows every species into the same shapes"
    if [ $code = 77 ]; then
        echo "ok $count - $text # SKIP this machine has no eight lanes"
    elif [ $code = 0 ] && [ ! -s "$out/err" ] && cmp -s "$out/hashes" "$out/known"; then
        echo "ok $count - $text"
    else
        echo "not ok $count - $text"
        { echo "exit $code"; head -5 "$out/err"; diff "$out/known" "$out/hashes"; } | sed 's/^/# /'
    fi
}

"$variants/gcc-O2/state_hash" 1 growth >"$out/known" # One vertex by one.
count=1
if [ "$(sort -u "$out/known" | wc -l)" -ge 3 ] && [ "$(wc -l <"$out/known")" = "$(sort -u "$out/known" | wc -l)" ]; then
    echo 'ok 1 - every species has a growth of its own'
else
    echo 'not ok 1 - every species has a growth of its own'
    sed 's/^/# /' "$out/known"
fi
for variant in gcc-O0 gcc-O2 gcc-O3 clang-O0 clang-O2 clang-O3 sanitized; do
    same $variant 4
    same $variant 8
done
echo "1..$count"
