#!/bin/bash
# test_morph_command.sh -- `kingyoctl morph` list, weights, growth, path and graph: awk and SQLite
# check their tables for every species and every template. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
root=$(cd "$(dirname "$0")/../.." && pwd)
morph() { "$ctl" morph "$@"; }
query() { sqlite3 :memory: "with r as (select readfile('$work/list.json') as j) select $1 from r"; }

# ---- The list
morph list --json >"$work/list.json"
mapfile -t species < <(sqlite3 :memory: "select json_extract(value, '\$.id') from json_each(readfile('$work/list.json'))")
list_is_valid() { [ "$(query 'json_valid(j)')" = 1 ] && [ "${#species[@]}" -ge 1 ]; }
check 'morph list --json is valid JSON' list_is_valid
listed_for_people() {
    morph list >"$work/list"
    cat "$work/list"
    [ "$(awk '{ print $1 }' "$work/list")" = "$(printf '%s\n' "${species[@]}")" ]
}
check 'the text of morph list has the same species as the JSON' listed_for_people
has_wakin() { printf '%s\n' "${species[@]}"; [ "${species[0]}" = wakin ]; }
check 'the wakin is the first species of morph list' has_wakin
key_names() { # SPECIES: Prints the names of the keys, one on each line.
    sqlite3 :memory: "select json_extract(k.value, '\$.name') from json_each(readfile('$work/list.json')) s,
        json_each(s.value, '\$.keys') k where json_extract(s.value, '\$.id')='$1' order by k.key"
}

# ---- Weights
head_is() { # SPECIES: The head of the table of weights has a column for each key.
    local expected
    expected=progress,age_days,length_mm,scale$(key_names "$1" | sed 's/^/,w_/' | tr -d '\n')
    [ "$(morph weights "$1" --steps 1 | head -1)" = "$expected" ] || { echo "$expected"; return 1; }
}
# The weights of each row sum to 1 within 1e-6, plus half a unit of the last printed digit for each
# weight. No weight is below 0. The scale is in (0, 1] and reaches 1. Progress and age rise.
weights_hold() { # ROWS OPTIONS...
    local rows=$1
    shift
    morph weights "$@" >"$work/w.csv" || return 1
    awk -F, -v rows="$rows" 'NR == 1 { columns = NF; next }
        { sum = 0; for (i = 5; i <= NF; i++) { sum += $i; if ($i < 0) bad = "below 0" }
          if ((sum - 1) ^ 2 > (1e-6 + 4e-7) ^ 2) bad = "sum " sum
          if (!($4 > 0 && $4 <= 1)) bad = "scale " $4
          if ($4 > top) top = $4
          if (NR > 2 && ($1 <= last || $2 < age)) bad = "order"
          if (NF != columns || $0 ~ /nan|inf/) bad = "columns"
          last = $1; age = $2; if (bad) { print bad ": " $0; exit } }
        END { if (!bad && (NR != rows + 1 || last != 1 || top < 0.99)) { bad = "rows " NR " top " top; print bad }
              exit bad != "" }' "$work/w.csv"
}
# At the progress of each key, the weight of that key is WEIGHT_OF_INNER, or 1 for the first and
# the last key.
key_weight() { # SPECIES WEIGHT_OF_INNER OPTIONS...
    local keys
    keys=$(key_names "$1" | wc -l)
    morph weights "$1" --steps $((12 * (keys - 1))) "${@:3}" >"$work/w.csv"
    awk -F, -v inner="$2" -v keys="$keys" 'NR > 1 && (NR - 2) % 12 == 0 { key = (NR - 2) / 12
        want = key == 0 || key == keys - 1 ? 1 : inner
        seen++; if (($(5 + key) - want) ^ 2 > 1e-12) { print "key", key, $0; bad = 1 } }
        END { exit bad || seen != keys }' "$work/w.csv"
}
for id in "${species[@]}"; do
    check "$id: the table head names the keys" head_is "$id"
    for template in own ordinary pairwise simultaneous smooth; do
        check "$id, $template: the weights sum to 1" weights_hold 201 "$id" --steps 200 --template $template
        check "$id, $template, --thesis: the weights sum to 1" weights_hold 98 "$id" --steps 97 --template $template --thesis
    done
    check "$id, pairwise: each key reaches the weight 1" key_weight "$id" 1 --template pairwise
    check "$id, simultaneous: inner keys peak at 70 %" key_weight "$id" 0.7 --template simultaneous
    check "$id, simultaneous --drawn: each key reaches the weight 1" key_weight "$id" 1 --template simultaneous --drawn
    check "$id, smooth --drawn: each key reaches the weight 1" key_weight "$id" 1 --template smooth --drawn
    check "$id, ordinary: inner keys have the weight 0" key_weight "$id" 0 --template ordinary
done
same_file() { # SPECIES: The built-in species and its text give the same tables.
    local words
    for words in "weights SPECIES" "path SPECIES --part eye --steps 20"; do
        # shellcheck disable=SC2086
        cmp <(morph ${words/SPECIES/$1}) <(morph ${words/SPECIES/$root/assets/species/$1.txt}) || return 1
    done
}
for id in "${species[@]}"; do
    check "$id: the text gives the same tables as the built-in species" same_file "$id"
done
packed() { # A packed species gives the same tables as its source.
    local words
    morph import "$work/packed.kfish" "$root/assets/species/hirame.txt" || return 1
    for words in "weights FISH --curve eye" "growth FISH" "path FISH --part eye --steps 20" "path FISH --part eye --steps 9 --thesis"; do
        # shellcheck disable=SC2086
        cmp <(morph ${words/FISH/hirame}) <(morph ${words/FISH/$work/packed.kfish}) || return 1
    done
}
check 'a packed flounder gives the same tables as the built-in flounder' packed
three_keys() {
    local wide
    for id in "${species[@]}"; do
        wide=$(morph weights "$id" --thesis --steps 1 | awk -F, 'NR == 1 { print NF }')
        [ "$wide" = 7 ] || { echo "$id: $wide columns"; return 1; }
    done
}
check '--thesis has three keys' three_keys

# ---- Growth: the table at hatching, at the end and between
growth_holds() { # SPECIES: Lengths rise on both curves. Hatching is on the shifted curve and the end on the plain one.
    morph growth "$1" --steps 400 >"$work/g.csv" || return 1
    awk -F, 'NR == 1 { if ($0 != "age_days,age_years,length_mm,von_bertalanffy_mm,shifted_mm") bad = "head"; next }
        NR == 2 && ($1 != 0 || ($3 - $5) ^ 2 > (1e-4 * $3) ^ 2 || $3 <= 0) { bad = "hatching" }
        ($2 * 365.25 - $1) ^ 2 > 0.01 { bad = "years" }
        NR > 2 && ($4 <= plain || $5 <= shifted) { bad = "falls" }
        { plain = $4; shifted = $5; ours = $3 }
        END { if ((ours - plain) ^ 2 > (0.002 * plain) ^ 2) bad = "the end " ours " " plain
              if (bad || NR != 402) { print bad, NR; exit 1 } }' "$work/g.csv"
}
for id in "${species[@]}"; do
    check "$id: growth begins with the true length and ends on the plain curve" growth_holds "$id"
done
thesis_growth() {
    diff <(morph growth wakin --thesis | cut -d, -f3) <(morph growth wakin | cut -d, -f5 | sed s/shifted_mm/length_mm/)
}
check "the growth of --thesis is the shifted curve" thesis_growth
thesis_is_as_long() { # SPECIES: At each of its keys the species is as long as `growth --thesis` prints.
    local age mm
    morph weights "$1" --thesis --steps 2 | awk -F, 'NR > 1 && $2 >= 1 { print $2, $3 }' >"$work/keys"
    [ -s "$work/keys" ] || return 1
    while read -r age mm; do
        morph growth "$1" --thesis --to-days "$age" --steps 1 | awk -F, -v mm="$mm" 'END {
            print $3, mm; exit ($3 - mm) ^ 2 > (1e-4 * mm) ^ 2 }' || return 1
    done <"$work/keys"
}
for id in "${species[@]}"; do
    check "$id: the lengths of weights --thesis equal those of growth --thesis" thesis_is_as_long "$id"
done
if [[ " ${species[*]} " == *' mebachi '* ]]; then
    # The plain curve gives 32.0 cm at hatching and 63.7 cm at one year; the shifted curve gives
    # 37.8 cm at one year (the fit of figure 3.6).
    bigeye() {
        morph growth mebachi --to-days 365.25 --steps 1 | awk -F, 'NR == 2 && ($4 < 317 || $4 > 323) { bad = 1 }
            NR == 3 && ($4 < 634 || $4 > 640 || $3 < 0.9 * $4 || $5 > 385) { bad = 1 } { print } END { exit bad }'
    }
    check 'the growth of mebachi follows figure 3.6 on the plain and on the shifted curve' bigeye
fi
if [[ " ${species[*]} " == *' kuroanago '* ]]; then
    shrinks() { # The length goes from 64 to 125.5, 56 and 72.5 mm, and then rises (table 2.7).
        morph weights kuroanago --steps 2000 | awk -F, 'NR > 1 { if ($3 > last) { if (down) turns++; down = 0 }
            else if ($3 < last) { if (!down) { turns++; top = last }; down = 1; low = $3 } last = $3 }
            END { print turns, top, low; exit !(turns == 2 && top > 125 && top < 126 && low > 55.5 && low < 56.5) }'
    }
    check 'the conger grows, shrinks and grows again' shrinks
fi

# ---- Paths
straight() { # COLUMN OPTIONS...: No row is farther from the chord than the rounding error.
    local column=$1
    shift
    morph path "$@" >"$work/p.csv" || return 1
    awk -F, -v c="$column" 'NR > 1 && $c > 2e-6 { print; bad = 1; exit } END { exit bad || NR < 10 }' "$work/p.csv"
}
bent() { # LEAST OPTIONS...: The largest distance from the chord is at least LEAST.
    local least=$1
    shift
    morph path "$@" >"$work/p.csv" || return 1
    awk -F, -v least="$least" 'NR > 1 && $7 > most { most = $7 } END { print most; exit most < least }' "$work/p.csv"
}
for id in "${species[@]}"; do
    check "$id: the ordinary morph moves an eye in a straight line" straight 11 "$id" --part eye
    check "$id: --template ordinary gives the straight line" straight 7 "$id" --part eye --template ordinary
done
check "the path of a wakin's dorsal fin is curved" bent 0.003 wakin --part dorsal
[[ " ${species[*]} " == *' kuroanago '* ]] && check "the path of a conger's dorsal fin is curved" bent 0.005 kuroanago --part dorsal
[[ " ${species[*]} " == *' hirame '* ]] && check "the path of a flounder's eye leads around its head" bent 0.02 hirame --part eye
# The tolerance is 0.002, because the diagonals of the skin's triangles are not mirrored. They
# cause a difference of 0.0019.
mirrored() {
    paste -d, <(morph path wakin --part eye --side right) <(morph path wakin --part eye --side left) |
        awk -F, 'NR > 1 && (($4 + $15) ^ 2 + ($5 - $16) ^ 2 + ($6 - $17) ^ 2 > 2e-3 ^ 2 || $4 <= 0) { print; bad = 1; exit }
            END { exit bad || NR < 100 }'
}
check "the left and the right eye of a goldfish are mirrored" mirrored

# ---- Pictures
drawn() { # LINES OPTIONS...: A complete SVG has at least LINES lines of the first key's colour.
    local least=$1
    shift
    morph "$@" --svg "$work/picture.svg" || return 1
    head -c 300 "$work/picture.svg"
    ! grep -qiE 'nan|inf["., ]' "$work/picture.svg" && grep -q '<svg xmlns="http://www.w3.org/2000/svg"' "$work/picture.svg" &&
        [ "$(tail -1 "$work/picture.svg")" = '</svg>' ] && [ "$(grep -c '#d23a2c' "$work/picture.svg")" -ge "$least" ]
}
for id in "${species[@]}"; do
    check "$id: morph graph writes an SVG" drawn 4 graph "$id"
    check "$id: morph path writes an SVG" drawn 2 path "$id" --part body --view side
done
for template in ordinary pairwise simultaneous smooth; do
    check "morph graph --template $template --thesis writes an SVG" drawn 4 graph wakin --template $template --thesis
    check "morph path --template $template --thesis writes an SVG" drawn 2 path wakin --part dorsal --template $template --thesis
done
has_curves() { # Each key has a curve, and the size has one more.
    morph graph wakin --svg "$work/graph.svg" && [ "$(grep -c 'stroke="#8e4bb8"' "$work/graph.svg")" -ge 2 ] &&
        [ "$(grep -cE '<polyline.{2000,}' "$work/graph.svg")" -eq $(($(key_names wakin | wc -l) + 1)) ]
}
odd_name() { # An id may begin with a character that has no capital form.
    sed 's/^species .*/species 2_koi/' "$root/assets/species/wakin.txt" >"$work/koi.txt"
    morph graph "$work/koi.txt" --svg "$work/koi.svg" && ! LC_ALL=C grep -q "$(printf '[\001-\010\016-\037]')" "$work/koi.svg" &&
        grep -q '>2 koi<' "$work/koi.svg"
}
colours_of() { # OPTIONS...: The colours of the keys' curves, in the order of the keys
    morph graph "$@" --svg "$work/colours.svg" &&
        sed -nE 's/.*stroke="(#[0-9a-f]{6})" stroke-width="3.5".*/\1/p' "$work/colours.svg" | paste -sd ' '
}
is_coloured() { # COLOURS OPTIONS...: The curves have COLOURS.
    local is
    is=$(colours_of "${@:2}")
    echo "$is"
    [ "$is" = "$1" ]
}
check 'five keys are coloured from red to green to blue' is_coloured '#d23a2c #dc7415 #2f9a4e #1c97a0 #2f6fd0' wakin
check 'the three keys of --thesis are red, green and blue' is_coloured '#d23a2c #2f9a4e #2f6fd0' wakin --thesis
# The graph labels the lengths at which a conger's growth reverses. The graph of --thesis does not
# label them.
turns() {
    morph graph kuroanago --svg "$work/turns.svg" && grep -q '>125.5 mm</text>' "$work/turns.svg" &&
        grep -q '>56.0 mm</text>' "$work/turns.svg" && grep -q 'by factors' "$work/turns.svg" &&
        morph graph kuroanago --thesis --svg "$work/turns.svg" && ! grep -qE '>56.0 mm<|by factors' "$work/turns.svg" &&
        grep -q '>0 mm</text>' "$work/turns.svg"
}
check "the graph labels the maximum and the minimum length of a conger" turns
# The first line of a species' text contains the kiosk's English name, without the part in
# brackets.
named() {
    local id name
    for id in "${species[@]}"; do
        name=$(sed -nE "s/^fish_$id = ([^(]*[^( ]).*/\1/p" "$root/assets/text/en.txt")
        echo "$id: $name"
        [ -n "$name" ] && head -1 "$root/assets/species/$id.txt" | grep -qi -- "$name" || return 1
    done
}
check "the text of each species gives the kiosk's English name" named
check 'an id that begins with a digit is drawn as a name' odd_name
check 'the graph has a curve for each key and one for the size' has_curves

# ---- Mistakes: one line that names the wrong argument, nothing on standard output
mistake() { # STATUS NEEDLE WORDS...: Exits with STATUS and one error line that contains NEEDLE.
    local expected=$1 needle=$2 status
    shift 2
    "$ctl" morph "$@" >"$work/out" 2>"$work/err"
    status=$?
    cat "$work/err"
    echo "exit $status"
    [ $status -eq "$expected" ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] &&
        grep -qF -- "$needle" "$work/err"
}
check 'a missing subcommand is wrong usage' mistake 2 missing
check 'an unknown subcommand is wrong usage' mistake 2 "'grow'" grow
check 'morph list with a species is wrong usage' mistake 2 wakin list wakin
for sub in weights growth path graph; do
    check "$sub without a species is wrong usage" mistake 2 'a species is missing' $sub
    check "$sub with an unknown species is wrong usage" mistake 2 "'koi'" $sub koi
    check "$sub with two species is wrong usage" mistake 2 "'wakin' is not understood" $sub wakin wakin
    check "$sub with an unknown option is wrong usage" mistake 2 "'--step'" $sub wakin --step 3
    check "$sub with an empty argument is wrong usage" mistake 2 "'' is not understood" $sub ''
    check "$sub of a missing text exits with 74" mistake 74 nowhere $sub "$work/nowhere.txt"
    check "$sub of a folder exits with 74" mistake 74 "$work" $sub "$work/."
    check "$sub of a missing packed species exits with 74" mistake 74 nowhere $sub "$work/nowhere.kfish"
done
check 'a fractional --steps is wrong usage' mistake 2 --steps weights wakin --steps 2.5
check '--steps 0 is wrong usage' mistake 2 '1 to 100000' growth wakin --steps 0
check '--steps above 100000 is wrong usage' mistake 2 '1 to 100000' path wakin --part eye --steps 100001
check '--steps without a number is wrong usage' mistake 2 --steps weights wakin --steps
check 'an unknown template is wrong usage' mistake 2 "'linear'" weights wakin --template linear
check '--template without a name is wrong usage' mistake 2 --template graph wakin --template
check 'an unknown curve is wrong usage' mistake 2 "'ear'" weights wakin --curve ear
check 'morph path without --part is wrong usage' mistake 2 '--part is missing' path wakin
check 'an unknown part is wrong usage' mistake 2 "'wing'" path wakin --part wing
check 'a part that the species lacks is wrong usage' mistake 2 'has no dorsal2' path wakin --part dorsal2
check 'an unknown side is wrong usage' mistake 2 "'up'" path wakin --part eye --side up
check 'an unknown view is wrong usage' mistake 2 "'below'" path wakin --part eye --svg "$work/x.svg" --view below
check '--view without --svg is wrong usage' mistake 2 '--view needs --svg' path wakin --part eye --view side
check 'a day before hatching is wrong usage' mistake 2 --to-days growth wakin --to-days -1
check '--to-days nan is wrong usage' mistake 2 --to-days growth wakin --to-days nan
check 'morph growth --template is wrong usage' mistake 2 --template growth wakin --template smooth
check 'morph graph without --svg is wrong usage' mistake 2 --svg graph wakin
check 'morph graph into a missing folder exits with 74' mistake 74 /nowhere/ graph wakin --svg /nowhere/g.svg
check 'morph path into a missing folder exits with 74' mistake 74 /nowhere/ path wakin --part eye --svg /nowhere/g.svg
check 'morph graph to a full disk exits with 74' mistake 74 /dev/full graph wakin --svg /dev/full
mkfifo "$work/pipe"
stays() { # WORDS...: A FIFO without a reader is refused, and stays a FIFO.
    timeout 60 "$ctl" morph "$@" >"$work/out" 2>"$work/err"
    local status=$?
    cat "$work/err"
    [ $status -eq 74 ] && [ "$(wc -l <"$work/err")" -eq 1 ] && [ -p "$work/pipe" ]
}
for to in 'graph wakin --svg' 'path wakin --part eye --svg' 'export wakin --sheet' 'export wakin --glb' \
    'export wakin --progress 1 --obj'; do
    # shellcheck disable=SC2086  # several arguments
    check "${to%% *} ${to##* } onto a FIFO without a reader exits with 74" stays $to "$work/pipe"
done
check 'morph import onto a FIFO exits with 74' stays import "$work/pipe" "$root/assets/species/wakin.txt"
check 'morph import onto a device exits with 74' mistake 74 /dev/null import /dev/null "$root/assets/species/wakin.txt"
check 'morph import to a full disk exits with 74' mistake 74 /dev/full import /dev/full "$root/assets/species/wakin.txt"
devices_stay() { [ -c /dev/null ] && [ -c /dev/full ]; }
check 'refused outputs leave the devices unchanged' devices_stay
onto_link() { # The SVG is written to the target of the link, and the link stays.
    : >"$work/drawing.svg"
    ln -s drawing.svg "$work/link.svg"
    morph graph wakin --svg "$work/link.svg" && [ -L "$work/link.svg" ] && grep -q '</svg>' "$work/drawing.svg" &&
        ! compgen -G "$work/*part*"
}
check 'an output through a symbolic link keeps the link' onto_link
full_output() {
    local status
    for words in list 'list --json' 'weights wakin --steps 5000' 'growth wakin' 'path wakin --part eye --steps 2' --help; do
        # shellcheck disable=SC2086
        morph $words >/dev/full
        status=$?
        [ $status -eq 74 ] || { echo "$words: $status"; return 1; }
    done
}
check 'a full standard output exits with 74' full_output
sed '0,/^station.*/s//station 0.00 wide/' "$root/assets/species/wakin.txt" >"$work/bad.txt"
check 'a wrong line of a species text exits with 65' mistake 65 'bad.txt:' weights "$work/bad.txt"
head -c 600 "$root/assets/species/wakin.txt" >"$work/short.txt"
check 'a truncated species text exits with 65' mistake 65 'short.txt' graph "$work/short.txt" --svg "$work/x.svg"
head -c 300 /dev/zero >"$work/zero.kfish"
check 'a packed species of zero bytes exits with 65' mistake 65 zero.kfish growth "$work/zero.kfish"
: >"$work/empty.txt"
check 'an empty species text exits with 65' mistake 65 empty.txt weights "$work/empty.txt"

# ---- Random arguments: the command succeeds or prints one error line, and never crashes
words=(wakin list weights growth path graph --template own smooth --thesis --steps 3 -1 1e9 --curve whole --part eye tail
    --side left --svg "$work/fuzz.svg" --view top --to-days '' % "$work/bad.txt" --drawn --json "$(printf 'x%.0s' {1..5000})")
any_words() { # Runs in the test's own folder, because an argument may become the name of an output file.
    local status program
    program=$(realpath "$ctl")
    RANDOM=7
    for _ in {1..250}; do
        local line=("${words[1 + RANDOM % 5]}")
        while [ $((RANDOM % 5)) -ne 0 ]; do line+=("${words[RANDOM % ${#words[@]}]}"); done
        (cd "$work" && "$program" morph "${line[@]}" >"$work/out" 2>"$work/err")
        status=$?
        case $status in
        0) [ ! -s "$work/err" ] ;;
        2 | 65 | 74) [ "$(wc -l <"$work/err")" -eq 1 ] && [ "$(wc -c <"$work/err")" -lt 600 ] ;;
        *) false ;;
        esac || { echo "exit $status: ${line[*]}" | cut -c1-300; cat "$work/err"; return 1; }
    done
}
check 'random arguments give a result or one error line' any_words
helps() {
    local sub
    for sub in list weights growth path graph; do
        morph $sub --help | grep -q "kingyoctl morph $sub" || return 1
        morph --help | grep -q "^  $sub " || return 1
    done
}
check '--help of each subcommand describes that subcommand' helps
echo "1..$count"
