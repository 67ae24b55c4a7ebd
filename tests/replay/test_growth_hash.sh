#!/bin/bash
# test_growth_hash.sh -- gcc and clang, -O0 to -O3, give identical shapes for every species, and the
# sanitizers report no undefined behaviour. All variants use the same baked tables. The build machine
# computes these tables with its libm in double precision, and another libm may round differently.
# BUILD is the folder that make uses. Speaks TAP. If a hash differs, the output gives the species.
set -u
variants=${BUILD:-build}/variants
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
count=0

same() { # VARIANT: VARIANT prints the same hashes as the variant gcc-O2.
    count=$((count + 1))
    "$variants/$1/state_hash" growth >"$out/hashes" 2>"$out/err"
    local code=$? text="$1 grows every species into the same shapes"
    if [ $code = 0 ] && [ ! -s "$out/err" ] && cmp -s "$out/hashes" "$out/known"; then
        echo "ok $count - $text"
    else
        echo "not ok $count - $text"
        { echo "exit $code"; head -5 "$out/err"; diff "$out/known" "$out/hashes"; } | sed 's/^/# /'
    fi
}

"$variants/gcc-O2/state_hash" growth >"$out/known"
count=1
if [ "$(sort -u "$out/known" | wc -l)" -ge 3 ] && [ "$(wc -l <"$out/known")" = "$(sort -u "$out/known" | wc -l)" ]; then
    echo 'ok 1 - every species has a different growth hash'
else
    echo 'not ok 1 - every species has a different growth hash'
    sed 's/^/# /' "$out/known"
fi
for variant in gcc-O0 gcc-O3 clang-O0 clang-O2 clang-O3 sanitized; do
    same $variant
done
echo "1..$count"
