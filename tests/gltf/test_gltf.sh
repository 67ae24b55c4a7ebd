#!/bin/bash
# test_gltf.sh -- check_glb.mjs checks every species and each of its curves as .glb, and nine moments
# of each as .obj. Speaks TAP; skipped with a reason if node, npm or Chromium is missing.
set -u
build=${BUILD:-build}
here=$(dirname "$0")
out=$build/gltf
skip() {
    echo "ok 1 - other programs accept the glTF files # skip $1"
    echo '1..1'
    exit 0
}
command -v node >/dev/null || skip 'node is not installed'
command -v npm >/dev/null || skip 'npm is not installed'
chromium=$(command -v chromium || command -v chromium-browser) || skip 'Chromium is not installed'
mkdir -p "$out"
cp "$here/package.json" "$here/package-lock.json" "$out/"
if ! [ "$out/node_modules" -nt "$out/package-lock.json.used" ] ||
    ! cmp -s "$here/package-lock.json" "$out/package-lock.json.used"; then
    (cd "$out" && npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1) ||
        skip 'npm cannot fetch the validators (no registry?)'
    cp "$here/package-lock.json" "$out/package-lock.json.used"
    touch "$out/node_modules"
fi
rm -rf "$out/files"
mkdir -p "$out/files"
export_one() { # NAME SPECIES OPTIONS...
    local name=$1 species=$2
    shift 2
    "$build/kingyoctl" morph export "$species" "$@" --glb "$out/files/$name.glb" || exit 1
    for progress in 0 0.0731 0.1873 0.3 0.5 0.618 0.7771 0.93 1; do
        "$build/kingyoctl" morph export "$species" "$@" --progress $progress \
            --obj "$out/files/$name@$progress.obj" || exit 1
    done
}
for species in $("$build/kingyoctl" morph list | awk '{ print $1 }'); do
    for template in own ordinary pairwise simultaneous smooth; do
        export_one "$species-$template" "$species" --template $template
    done
    export_one "$species-thesis" "$species" --thesis
done
node "$here/check_glb.mjs" "$out/files" "$out" "$chromium" >"$out/results"
sed '/^1\.\./d' "$out/results"
count=$(grep -cE '^(not )?ok' "$out/results")

# The check itself is tested: it must detect the error in each of these files.
rm -rf "$out/damaged"
mkdir -p "$out/damaged"
node "$here/damage_glb.mjs" "$out/files/hirame-own.glb" "$out/damaged" || exit 1
for damaged in "$out"/damaged/*.glb; do
    for moment in "$out"/files/hirame-own@*.obj; do
        cp "$moment" "${damaged%.glb}@${moment##*@}"
    done
done
node "$here/check_glb.mjs" "$out/damaged" "$out" "$chromium" >"$out/results" 2>&1
for damaged in "$out"/damaged/*.glb; do
    name=$(basename "$damaged" .glb)
    count=$((count + 1))
    found=$(sed -n "s/^not ok [0-9]* - $name: //p" "$out/results" | head -1)
    echo "$([ -n "$found" ] || echo 'not ')ok $count - the check detects $name: $found"
done
echo "1..$count"
