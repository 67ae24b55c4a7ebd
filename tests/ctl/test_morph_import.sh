#!/bin/bash
# test_morph_import.sh -- species of other makers: kingyoctl packs or rejects them, and the kiosk
# loads them. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
root=$(cd "$(dirname "$0")/../.." && pwd)
morph() { "$ctl" morph "$@"; }
corpus=$root/tests/fuzz/corpus
mistake() { # STATUS WORDS ARGUMENTS...: Prints one line that contains WORDS, within 20 s and 2 GiB.
    local expected=$1 words=$2 status
    shift 2
    (
        ulimit -v 2097152
        timeout 20 "$ctl" morph "${of:-import}" "$@" >"$work/out" 2>"$work/err"
    )
    status=$?
    cat "$work/out" "$work/err"
    [ $status -eq "$expected" ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] &&
        grep -qF -- "$words" "$work/err"
}

# ---- Texts
for text in "$root"/assets/species/*.txt; do
    id=$(basename "$text" .txt)
    check "morph import packs $id" morph import "$work/$id.kfish" "$text"
    # The varieties of the goldfish are only drawn. The program has no species of their names.
    case $id in demekin | ryukin) like=$text ;; *) like=$id ;; esac
    same_weights() { [ -s "$work/weights" ] && cmp "$work/weights" <(morph weights "$work/$id.kfish" --steps 50); }
    morph weights "$like" --steps 50 >"$work/weights"
    check "the packed $id has the weights of $(basename "$like")" same_weights
done
check '--id renames a species' morph import "$work/pet.kfish" "$root/assets/species/wakin.txt" --id pet
echo 'species x' >"$work/short.txt"
check 'a truncated text exits with 65' mistake 65 short.txt:1: "$work/x.kfish" "$work/short.txt"
printf 'species x\n\033[31mred\233 1\n' >"$work/esc.txt"
check 'the error masks control characters of a text' mistake 65 "esc.txt:2: '?[31mred?' is not a keyword" "$work/x.kfish" "$work/esc.txt"
printf 'species x\nmeasure total\0 and more\n' >"$work/zero.txt"
check 'a zero byte in a text exits with 65' mistake 65 'zero.txt:2: the line is longer than 255 characters or contains a zero byte' "$work/x.kfish" "$work/zero.txt"
ln -s /dev/zero "$work/endless.txt" && ln -s /dev/zero "$work/endless.obj"
check 'an endless text exits with 74' mistake 74 'endless.txt: is not a regular file' "$work/x.kfish" "$work/endless.txt"
truncate -s 2M "$work/large.txt"
check 'a text of 2 MiB exits with 65' mistake 65 'large.txt: is larger than 1 MiB' "$work/x.kfish" "$work/large.txt"
mkfifo "$work/pipe.kfish"
check 'an output onto a FIFO exits with 74' mistake 74 'pipe.kfish: ' "$work/pipe.kfish" "$root/assets/species/wakin.txt"
check 'the FIFO is not replaced' test -p "$work/pipe.kfish"
check 'a missing text exits with 74' mistake 74 nowhere.txt "$work/x.kfish" "$work/nowhere.txt"
check 'an output into a missing folder exits with 74' mistake 74 nowhere "$work/nowhere/x.kfish" "$root/assets/species/wakin.txt"
check 'a missing input is wrong usage' mistake 2 'OUT.kfish' "$work/x.kfish"
check 'an unknown option is wrong usage' mistake 2 --colour "$work/x.kfish" a.obj --colour red
check 'an invalid --front is wrong usage' mistake 2 --front "$work/x.kfish" a.obj --front sideways

# ---- OBJ: three shapes of one topology
for key in a b c; do
    awk -v s="$(printf '%d' "'$key")" '$1 == "v" { printf "v %g %g %g\n", $2 * (1 + (s - 97) / 5), $3, $4; next } { print }' \
        "$corpus/obj/fish.obj" >"$work/$key.obj"
done
objs=("$work/a.obj" "$work/b.obj" "$work/c.obj")
check 'three OBJ files become a species' morph import "$work/small.kfish" "${objs[@]}" --lengths-mm 10,20,40 --ages-days 0,30,90
prints_lengths() { morph list >/dev/null && morph weights "$work/small.kfish" --steps 2 | tee "$work/w" | tail -1 | grep -q '^1.000000,90.000,40.0000,'; }
check 'the species has the given ages and lengths' prints_lengths
check 'OBJ files of one size need --lengths-mm' mistake 65 'use --lengths-mm' "$work/x.kfish" "${objs[@]}"
check 'two OBJ files exit with 65' mistake 65 'a species has 3 to 8' "$work/x.kfish" "$work/a.obj" "$work/b.obj"
check 'a wrong number of lengths exits with 65' mistake 65 '--lengths-mm: 2' "$work/x.kfish" "${objs[@]}" --lengths-mm 1,2
for growth in 500,0.3,-0.1,3,0 500,0,-0.1,3,0.3 500,0.3,99,3,0.3 0,0.3,-0.1,3,0.3 500,0.3,-0.1,0,0.3; do
    check "--growth $growth is wrong usage" mistake 2 "--growth: '$growth' is wrong" "$work/x.kfish" "${objs[@]}" \
        --lengths-mm 5,10,20 --growth "$growth"
done
check 'a length of 0 is wrong usage' mistake 2 '--lengths-mm' "$work/x.kfish" "${objs[@]}" --lengths-mm 0,10,20
check 'an age before hatching is wrong usage' mistake 2 '--ages-days' "$work/x.kfish" "${objs[@]}" --lengths-mm 5,10,20 --ages-days -1,2,3
check 'ages that contradict the growth curve exit with 65' mistake 65 'a/length_m: 0.005 at 100 days, but the growth curve gives' "$work/x.kfish" \
    "${objs[@]}" --lengths-mm 5,10,20 --ages-days 100,200,300 --growth 500,0.3,-0.1,3,0.3
sed 's/^key koaka 45$/key koaka 45 200/' "$root/assets/species/wakin.txt" >"$work/late.txt"
check 'a text with an age that contradicts its growth exits with 65' mistake 65 'late.txt:175: key koaka is 45 mm long at 200 days, but the growth curve gives' "$work/x.kfish" "$work/late.txt"
head -5 "$work/b.obj" >"$work/cut.obj"
check 'a truncated first OBJ file exits with 65' mistake 65 'cut.obj:5: no faces' "$work/x.kfish" "$work/cut.obj" "$work/b.obj" "$work/c.obj"
check 'a truncated second OBJ file exits with 65' mistake 65 'cut.obj:5: no faces' "$work/x.kfish" "$work/a.obj" "$work/cut.obj" "$work/c.obj"
check 'an endless OBJ file exits with 74' mistake 74 'endless.obj: is not a regular file' "$work/x.kfish" "$work/endless.obj" "$work/b.obj" "$work/c.obj"
truncate -s 65M "$work/large.obj"
check 'an OBJ file of 65 MiB exits with 65' mistake 65 'larger than 64 MiB' "$work/x.kfish" "$work/large.obj" "$work/b.obj" "$work/c.obj"

# ---- Unequal topology: a template is fitted to the meshes
morph export wakin --progress 1 --obj "$work/grown.obj" >/dev/null 2>&1
marks() { # OBJ: Prints four landmarks of the mesh.
    awk '$1 == "v" { n++; x[n] = $2; y[n] = $3; z[n] = $4 }
        $1 == "g" { body = $2 == "body" }
        body && $1 == "f" { for (i = 2; i <= 4; i++) { split($i, c, "/"); v = c[1]
            if (!snout || z[v] < z[snout]) snout = v
            if (!root || z[v] > z[root]) root = v
            if (!back || y[v] > y[back]) back = v
            if (!belly || y[v] < y[belly]) belly = v } }
        function tell(name, v) { print name, x[v], y[v], z[v] }
        END { tell("snout", snout); tell("tail_root", root); tell("back", back); tell("belly", belly) }' "$1"
}
keys=$(morph weights kurodai --steps 1 | head -1 | tr , '\n' | grep -c '^w_')
meshes=()
for ((i = 0; i < keys; i++)); do
    meshes+=("$work/fit$i.obj")
    morph export wakin --progress "$(awk "BEGIN { print $i / ($keys - 1) }")" --obj "$work/fit$i.obj" >/dev/null 2>&1
    marks "$work/fit$i.obj" >"$work/fit$i.marks"
done
fits() { morph refit "$work/fitted.kfish" kurodai "${meshes[@]}" --id fitted >"$work/fits"; }
fitted_well() { # Each mean error is within 0.4 % of the length, from the fit to the mesh and back.
    cat "$work/fits"
    awk -v keys="$keys" '/mean/ { split($0, p, /mean |mesh to fit: /); n++; if (p[2] + 0 > 0.4 || p[3] + 0 > 0.4) bad = 1 }
        END { exit !(n == keys && !bad) }' "$work/fits"
}
check 'morph refit fits a bream to goldfish by four landmarks' fits
check 'the mean error of the fit is within 0.4 % of the length' fitted_well
check 'morph weights reads the fitted species' morph weights "$work/fitted.kfish" --steps 4
awk '$1 == "tail_root" { $3 += 0.002 } { print }' "$work/fit0.marks" >"$work/stray.marks"
strays() { morph refit "$work/x.kfish" kurodai "${meshes[@]}" --marks "$work/stray.marks,$1,$1,$1,$1" 2>&1 >/dev/null |
    grep -E '^[^ ]*stray.marks: landmark tail_root is [1-9][0-9] % of the length away from the mesh$'; }
check 'a landmark away from the mesh is reported' strays "$work/fit1.marks"
of_refit() { of=refit mistake "$@"; }
check 'a missing file of landmarks exits with 74' of_refit 74 grown.marks "$work/x.kfish" wakin "$work/grown.obj" "$work/grown.obj" \
    "$work/grown.obj" "$work/grown.obj" "$work/grown.obj"
check 'an unknown template is wrong usage' of_refit 2 "'karp' is not a species; write wakin" "$work/x.kfish" karp "$work/grown.obj"
check 'morph refit without a mesh is wrong usage' of_refit 2 'a mesh for each key' "$work/x.kfish" wakin
check 'morph refit --colours is wrong usage' of_refit 2 'unknown option' "$work/x.kfish" wakin --colours 0,0,0,0,0 "$work/grown.obj"
check 'a wrong number of meshes is wrong usage' of_refit 2 'and there are 1 files' "$work/x.kfish" wakin "$work/grown.obj"

# ---- glTF
if morph import "$work/x.kfish" "$corpus/scene/fish.glb" --lengths-mm 1,2,3 >"$work/scene" 2>&1; then
    back() {
        morph export "$1" --glb "$work/$1.glb" && morph import "$work/back.kfish" "$work/$1.glb" --id back &&
            morph weights "$work/back.kfish" --steps 4
    }
    check 'morph targets become keys, and their animation becomes the growth graph' grep -q 'graph  *3 knots of 3 moments' "$work/scene"
    check 'an exported .glb file can be imported' back hirame
    refuse() { check "$1.glb" mistake 65 "$1.glb: $2" "$work/x.kfish" "$corpus/scene/$1.glb" --lengths-mm 1,2,3; }
    refuse cyclic_nodes 'GLTF: '
    refuse huge_count 'GLTF: '
    refuse huge_view 'GLTF: '
    refuse missing_node 'GLTF: '
    refuse index_off 'a triangle refers to a missing vertex'
    refuse nan 'a coordinate is not a number'
    refuse no_faces ''
    refuse points 'no triangles'
    refuse not_json ''
    refuse short_target ''
    refuse weights_over_one "the animation's moment 0"
else
    for what in targets comes-back hostile; do
        count=$((count + 1))
        echo "ok $count - glTF, $what # skip $(head -1 "$work/scene")"
    done
fi
check 'a missing scene exits with 74' mistake 74 nowhere.glb "$work/x.kfish" "$work/nowhere.glb"

# ---- The kiosk reads packed species, and contains no importer
kiosk_is_free_of_assimp() {
    ! ldd "$build/kingyo" | grep -i assimp && ! strings -a "$build/kingyo" | grep -i 'libassimp' &&
        ! nm "$build/kingyo" | grep -i 'import_'
}
check 'the kiosk contains no importer' kiosk_is_free_of_assimp
mkdir -p "$work/data/species"
cp "$work/small.kfish" "$work/pet.kfish" "$work/data/species/"
head -c 900 "$work/pet.kfish" >"$work/data/species/cut.kfish"
cp "$work/wakin.kfish" "$work/data/species/twin.kfish"
opens() {
    timeout 100 "$build/kingyo" --demo 5 --window 320x240 --data "$work/data" --shots "$work/shots"
    status=$?
    [ $status -le 1 ]
}
opens >"$work/output" 2>&1
check 'the kiosk opens with invalid species' grep -q '^Kingyo .* played by the bot' "$work/output"
check 'the kiosk reports each loaded species' grep -q 'species  *species/small.kfish: small' "$work/output"
check 'the kiosk reports a rejected species with the reason' grep -q 'species/cut.kfish: size: ' "$work/output"
check 'the kiosk rejects a second species of the same id' grep -q "species/twin.kfish: id: the species 'wakin' exists already" "$work/output"
echo "1..$count"
