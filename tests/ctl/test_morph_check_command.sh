#!/bin/bash
# test_morph_check_command.sh -- `kingyoctl morph check` as its users see it: every species is judged good, a
# spoiled one is not, and the same figures stand in text and JSON. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
root=$(cd "$(dirname "$0")/../.." && pwd)
morph() { "$ctl" morph "$@"; }
query() { sqlite3 :memory: "with r as (select readfile('$work/check.json') as j) select $1 from r"; }

mapfile -t species < <(morph list | awk '{ print $1 }')
is_good() { # SPECIES
    morph check "$1" --steps 500 --json >"$work/check.json" || { cat "$work/check.json"; return 1; }
    [ "$(query 'json_valid(j)')" = 1 ] && [ "$(query "json_extract(j, '\$.good')")" = 1 ] &&
        [ "$(query "json_extract(j, '\$.moments')")" = 501 ]
}
for id in "${species[@]}"; do
    check "$id grows without a flaw" is_good "$id"
done

# ---- What the ordinary morph does to a flatfish, and the thesis' way does not
through_the_head() {
    morph check hirame --template ordinary --steps 500 --json >"$work/check.json"
    [ $? = 1 ] || return 1
    query "json_extract(j, '\$.near.pupil_in_body')"
    [ "$(query "json_extract(j, '\$.near.pupil_in_body') > 0.02")" = 1 ] &&
        [ "$(query "json_extract(j, '\$.near.eye_right') < 1e-6")" = 1 ]
}
check "hirame's ordinary eye goes straight through its head, and the status says so" through_the_head
round_the_head() {
    morph check hirame --steps 500 --json >"$work/check.json"
    [ "$(query "json_extract(j, '\$.near.pupil_in_body') = 0")" = 1 ] &&
        [ "$(query "json_extract(j, '\$.near.eye_right') > 0.05")" = 1 ]
}
check "ours goes round it on a curve" round_the_head

# ---- Text
text_tells() {
    morph check wakin --steps 50 >"$work/text"
    cat "$work/text"
    grep -q '^wakin: [0-9]* keys' "$work/text" && grep -q 'near *far *ordinary' "$work/text" &&
        grep -q 'key, where shown alone, missed by *0.0e+00' "$work/text"
}
check 'the table names its columns and its figures' text_tells

# ---- A spoiled drawing: the third key's pectoral fins swept back through the flanks
spoiled() {
    awk '/^key / { k++ } /^fin / { f = $2 } /^ray / && k == 3 && f == "pectoral" { $4 = 150; $5 = 0 } { print }' \
        "$root/assets/species/wakin.txt" >"$work/sunk.txt"
    morph check "$work/sunk.txt" --steps 200 >"$work/text"
    [ $? = 1 ] || { cat "$work/text"; return 1; }
    grep -q '^not so (near): fin deeper than its root.* at progress .* (pectoral)' "$work/text"
}
check 'a spoiled drawing is not good, and it says what and where' spoiled

refused() { # WORDS...
    morph check "$@" >"$work/out" 2>"$work/err"
    [ $? = 2 ] && [ "$(wc -l <"$work/err")" = 1 ] && [ ! -s "$work/out" ]
}
check 'no steps are refused' refused wakin --steps 0
check 'a species that is not is refused' refused carp
check 'no species is refused' refused
echo "1..$count"
