#!/bin/bash
# test_morph_export_command.sh -- `kingyoctl morph export`: meshes and pictures that other programs
# can read, the age or length that the options select, and one line for each mistake. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
root=$(cd "$(dirname "$0")/../.." && pwd)
export_of() { "$ctl" morph export "$@"; }
mapfile -t species < <("$ctl" morph list | awk '{ print $1 }')

# ---- OBJ
# The file has as many vt and vn lines as v lines, colours in [0, 1] and unit normals. Each face
# refers to existing vertices and belongs to a group.
obj_is_whole() { # SPECIES OPTIONS...
    export_of "$@" --obj "$work/fish.obj" || return 1
    awk '/^v / { v++; for (i = 5; i <= 7; i++) if ($i < 0 || $i > 1) bad = "colour"; if (NF != 7) bad = "v" }
        /^vt / { vt++ } /^vn / { vn++; n = $2 * $2 + $3 * $3 + $4 * $4; if ((n - 1) ^ 2 > 1e-4) bad = "normal " $0 }
        /^g / { groups[$2]++; if (groups[$2] > 1) bad = "group twice" ; named = 1 }
        /^f / { f++; if (!named || NF != 4) bad = "face"
                for (i = 2; i <= 4; i++) { split($i, c, "/"); if (c[1] < 1 || c[1] > v || c[2] != c[1] || c[3] != c[1]) bad = "corner"
                                           used[c[1]] = 1 } }
        /nan|inf/ { bad = "no number" }
        END { for (i in used) count++
              if (bad || v < 100 || vt != v || vn != v || f < 100 || count != v || !("body" in groups) || !("eye_left" in groups)) {
                  print bad, v, vt, vn, f, count; exit 1 } }' "$work/fish.obj"
}
# Prints the extent of all vertices along z, in mm.
obj_long_mm() {
    awk '/^v / { z = 1000 * $4; if (!seen++ || z < low) low = z; if (seen == 1 || z > high) high = z }
        END { printf "%.6f\n", high - low }' "$1"
}
for fish in "${species[@]}"; do
    check "$fish: the OBJ file is valid" obj_is_whole "$fish" --progress 0.4
    check "$fish: the OBJ file of --thesis is valid" obj_is_whole "$fish" --progress 0.7 --thesis
done
true_size() { # SPECIES MM MORE...: A species whose measure is the total length
    export_of "$1" --length-mm "$2" --obj "$work/size.obj" || return 1
    obj_long_mm "$work/size.obj" | awk -v want="$2" '{ print; exit ($1 / want - 1) ^ 2 > 0.02 ^ 2 }'
}
check 'a goldfish of 45 mm is exported with a length of 45 mm' true_size wakin 45
check 'a goldfish of 150 mm is exported with a length of 150 mm' true_size wakin 150
same_moment() { # --progress, --age-days and --length-mm select the same shape.
    local age mm
    read -r age mm < <("$ctl" morph weights wakin --steps 4 | awk -F, 'NR == 4 { print $2, $3 }') # Line 4 is progress 0.5.
    export_of wakin --progress 0.5 --obj "$work/p.obj" && export_of wakin --age-days "$age" --obj "$work/a.obj" &&
        export_of wakin --length-mm "$mm" --obj "$work/l.obj" || return 1
    for other in a l; do
        paste <(grep '^v ' "$work/p.obj") <(grep '^v ' "$work/$other.obj") |
            awk '{ for (i = 2; i <= 4; i++) if (($i - $(i + 7)) ^ 2 > 1e-5 ^ 2) bad = $0 } END { print bad; exit bad != "" }' || return 1
    done
}
check 'progress, age and length select the same shape' same_moment
differ() { # OPTIONS... -- OPTIONS...: The two sets of options give different shapes.
    local first=()
    while [ "$1" != -- ]; do first+=("$1"); shift; done
    shift
    export_of "${first[@]}" --obj "$work/one.obj" && export_of "$@" --obj "$work/two.obj" || return 1
    ! cmp -s <(grep '^v ' "$work/one.obj") <(grep '^v ' "$work/two.obj")
}
check '--template ordinary gives another shape' differ hirame --progress 0.3 -- hirame --progress 0.3 --template ordinary
check "--thesis gives another shape" differ hirame --progress 0.3 -- hirame --progress 0.3 --thesis
check 'pairwise and simultaneous give different shapes' differ hirame --progress 0.3 --template pairwise -- hirame --progress 0.3 --template simultaneous
made_file() {
    export_of "$root/assets/species/wakin.txt" --progress 0.5 --obj "$work/file.obj" &&
        export_of wakin --progress 0.5 --obj "$work/table.obj" || return 1
    paste <(grep '^v ' "$work/file.obj") <(grep '^v ' "$work/table.obj") |
        awk '{ for (i = 2; i <= 4; i++) if (($i - $(i + 7)) ^ 2 > 1e-6 ^ 2) bad = $0 } END { print bad; exit bad != "" }'
}
check "a species text gives the same mesh as the built-in species" made_file

# ---- glTF: the structure of the file; tests/gltf checks the content
word() { od -An -tu4 -j "$2" -N4 "$1" | tr -d ' '; } # FILE OFFSET
json_of() { dd if="$1" bs=1 skip=20 count="$(word "$1" 12)" status=none; }
glb_is_whole() { # OPTIONS...: The file has the head and the size of glTF 2, and its JSON is valid.
    export_of "$@" --glb "$work/fish.glb" || return 1
    [ "$(head -c4 "$work/fish.glb")" = glTF ] && [ "$(word "$work/fish.glb" 4)" = 2 ] &&
        [ "$(word "$work/fish.glb" 8)" = "$(stat -c%s "$work/fish.glb")" ] || return 1
    json_of "$work/fish.glb" >"$work/fish.json"
    [ "$(sqlite3 :memory: "select json_valid(readfile('$work/fish.json'))")" = 1 ]
}
of_json() { sqlite3 :memory: "with r as (select readfile('$work/fish.json') as j) select $1 from r"; }
for fish in "${species[@]}"; do
    check "$fish: the .glb file is valid" glb_is_whole "$fish"
done
names_targets() { # The first target is named after the first key of the whole fish's curve.
    glb_is_whole wakin || return 1
    of_json "json_extract(j, '\$.meshes[0].extras.targetNames')"
    [ "$(of_json "json_extract(j, '\$.meshes[0].extras.targetNames[0]') = json_extract(j, '\$.nodes[0].extras.keys[0].name')")" = 1 ]
}
check 'the morph targets are named after the keys' names_targets
names_curves() {
    glb_is_whole hirame --template smooth &&
        [ "$(of_json "json_extract(j, '\$.nodes[0].extras.template') = 'smooth'")" = 1 ]
}
check 'the .glb file names the template of its curves' names_curves
# The output of the scale channel ends at the adult's length.
scale_is_animated() {
    glb_is_whole wakin || return 1
    [ "$(of_json "(select count(*) from json_each(j, '\$.animations[0].channels') c where json_extract(c.value, '\$.target.path') = 'scale')")" = 1 ] &&
        [ "$(of_json "abs(json_extract(j, '\$.nodes[0].scale[0]') - json_extract(j, '\$.nodes[0].extras.keys[4].length_m')) < 1e-6")" = 1 ]
}
check "the size is an animated scale that rests at the adult's length" scale_is_animated

# ---- Pictures
sheet_is() { # SPECIES OPTIONS...: The sheet is a PNG 2400 pixels wide with at least 1000 colours.
    export_of "$@" --sheet "$work/sheet.png" || return 1
    identify -format '%m %w %h %k\n' "$work/sheet.png" | tee "$work/size"
    awk '$1 != "PNG" || $2 != 2400 || $3 < 900 || $4 < 1000 { exit 1 }' "$work/size"
}
check 'the sheet is a PNG with many colours' sheet_is wakin # test_fish_preview.c draws every species.
check "the sheet of --thesis is a PNG with many colours" sheet_is hirame --thesis
frames_are() { # COUNT OPTIONS...: COUNT pictures of 1280x720 are written into a new folder.
    local count=$1
    shift
    rm -rf "$work/frames"
    export_of "$@" --frames "$count" --dir "$work/frames/deep" || return 1
    [ "$(ls "$work/frames/deep" | wc -l)" = "$count" ] &&
        [ "$(identify -format '%w %h\n' "$work"/frames/deep/*.png | sort -u)" = '1280 720' ]
}
check '--frames writes the requested number of pictures and creates the folder' frames_are 3 wakin
move() { ! cmp -s "$work/frames/deep/wakin_0000.png" "$work/frames/deep/wakin_0002.png"; }
check 'the first and the last frame differ' move
for view in side above aslant; do
    check "--view $view writes frames" frames_are 2 ray --view $view
done
again() {
    export_of hirame --glb "$work/1.glb" && export_of hirame --glb "$work/2.glb" && cmp "$work/1.glb" "$work/2.glb"
}
check 'the same arguments write the same bytes' again

# ---- Mistakes: one line, the right exit code, no file left behind
refused() { # CODE PATTERN OPTIONS...: Exits with CODE and one error line that matches PATTERN.
    local code=$1 pattern=$2 got
    shift 2
    export_of "$@" >"$work/out" 2>"$work/err"
    got=$?
    cat "$work/err"
    [ "$got" = "$code" ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" = 1 ] && grep -qE -- "$pattern" "$work/err"
}
f=$work/never
check 'a missing species is wrong usage' refused 2 'species is missing' --sheet "$f"
check 'an unknown species is wrong usage' refused 2 "'nemo' is not a species" nemo --sheet "$f"
check 'a missing output is wrong usage' refused 2 'the output is missing' wakin
check 'two outputs are wrong usage' refused 2 'more than one output' wakin --sheet "$f" --glb "$f"
check '--obj without an age, a length or a progress is wrong usage' refused 2 '--obj needs' wakin --obj "$f"
check '--obj with both a progress and a length is wrong usage' refused 2 'only one of --progress' wakin --obj "$f" --progress 0.5 --length-mm 30
check 'a progress above 1 is wrong usage' refused 2 "--progress: '1.5'" wakin --obj "$f" --progress 1.5
check 'an age that is not a number is wrong usage' refused 2 "--age-days: 'old'" wakin --obj "$f" --age-days old
check '--glb with a progress is wrong usage' refused 2 'need --obj' wakin --glb "$f" --progress 0.5
check 'an age before the first key is wrong usage' refused 2 'hirame is drawn from 22 to 1462.83 days' hirame --obj "$f" --age-days 1
check 'a length below the first key is wrong usage' refused 2 '--length-mm: 3 is outside the drawn life: hirame is drawn from 9.5 to 500 mm' hirame --obj "$f" --length-mm 3
check 'an age after the last key is wrong usage' refused 2 '--age-days: 600 is outside' wakin --obj "$f" --age-days 600
check 'a length above the last key is wrong usage' refused 2 '--length-mm: 151 is outside' wakin --obj "$f" --length-mm 151
check 'a length of a conger below its first key is accepted' export_of kuroanago --length-mm 60 --obj "$work/short.obj"
check 'the age that morph weights prints is accepted' export_of wakin --age-days 545.4 --obj "$work/old.obj"
check '--sheet with a length is wrong usage' refused 2 'need --obj' wakin --sheet "$f" --length-mm 5
check '--frames without --dir is wrong usage' refused 2 'must be used together' wakin --frames 4
check '--dir without --frames is wrong usage' refused 2 'must be used together' wakin --sheet "$f" --dir "$work"
check '--frames 1 is wrong usage' refused 2 "--frames: '1'" wakin --frames 1 --dir "$work/d"
check '--frames 1000000 is wrong usage' refused 2 "--frames: '1000000'" wakin --frames 1000000 --dir "$work/d"
check 'an unknown view is wrong usage' refused 2 "--view: 'below'" wakin --frames 2 --dir "$work/d" --view below
check '--view without --frames is wrong usage' refused 2 '--view needs --frames' wakin --sheet "$f" --view side
check '--glb without a file is wrong usage' refused 2 '--glb needs a value' wakin --glb
check 'an unknown template is wrong usage' refused 2 '--template' wakin --glb "$f" --template best
check 'an unknown option is wrong usage' refused 2 "unknown option '--stl'" wakin --stl "$f"
check 'a missing species text exits with 74' refused 74 'No such file' "$work/no.txt" --glb "$f"
printf 'species x\nkey a 1\n' >"$work/bad.txt"
check 'an invalid species text exits with 65' refused 65 'bad.txt:' "$work/bad.txt" --glb "$f"
for kind in sheet glb obj; do
    moment=()
    [ $kind = obj ] && moment=(--progress 0.5)
    check "--$kind into a missing folder exits with 74" refused 74 'No such file' wakin "${moment[@]}" --$kind "$work/no/x"
    check "--$kind onto a folder exits with 74" refused 74 'Is a directory' wakin "${moment[@]}" --$kind "$work"
    check "--$kind to a full disk exits with 74" refused 74 'No space left' wakin "${moment[@]}" --$kind /dev/full
    full() { (trap '' XFSZ; ulimit -f 8; refused 74 'too large' wakin "${moment[@]}" --$kind "$f"); }
    check "--$kind beyond the file size limit exits with 74" full
done
frames_full() { (trap '' XFSZ; ulimit -f 8; refused 74 'wakin_0000.png: File too large' wakin --frames 2 --dir "$work/none"); }
check '--frames beyond the file size limit exits with 74' frames_full
nothing_left() { ls "$work/none"; [ ! -e "$f" ] && [ -z "$(ls "$work/none")" ] && [ -c /dev/full ]; }
check 'failed exports leave no file behind' nothing_left
check '--dir with a file exits with 74' refused 74 'Not a directory|File exists' wakin --frames 2 --dir "$work/bad.txt"
help_lists_options() { "$ctl" morph export --help | tee "$work/help"; for o in --sheet --frames --obj --glb --view; do grep -q -- "$o" "$work/help" || return 1; done; }
check '--help lists the options' help_lists_options

echo "1..$count"
