#!/bin/bash
# test_morph_check_command.sh -- `kingyoctl morph check`: every species passes, a damaged species
# fails, and the text has the figures of the JSON. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
root=$(cd "$(dirname "$0")/../.." && pwd)
morph() { "$ctl" morph "$@"; }
query() { sqlite3 :memory: "with r as (select readfile('$work/check.json') as j) select $1 from r"; }

mapfile -t species < <(morph list | awk '{ print $1 }')
is_good() { # SPECIES: All 501 moments of growth are checked, and no flaw is found.
    morph check "$1" --steps 500 --json >"$work/check.json" || { cat "$work/check.json"; return 1; }
    [ "$(query 'json_valid(j)')" = 1 ] && [ "$(query "json_extract(j, '\$.good')")" = 1 ] &&
        [ "$(query "json_extract(j, '\$.moments')")" = 501 ]
}
for id in "${species[@]}"; do
    check "morph check of $id reports no flaw" is_good "$id"
done

# ---- The ordinary morph of a flatfish moves an eye through its head; the method of the thesis does not
through_the_head() {
    morph check hirame --template ordinary --steps 500 --json >"$work/check.json"
    [ $? = 1 ] || return 1
    query "json_extract(j, '\$.near.pupil_in_body')"
    [ "$(query "json_extract(j, '\$.near.pupil_in_body') > 0.02")" = 1 ] &&
        [ "$(query "json_extract(j, '\$.near.eye_right') < 1e-6")" = 1 ]
}
check "the ordinary morph of hirame moves the eye through the head and exits with 1" through_the_head
round_the_head() {
    morph check hirame --steps 500 --json >"$work/check.json"
    [ "$(query "json_extract(j, '\$.near.pupil_in_body') = 0")" = 1 ] &&
        [ "$(query "json_extract(j, '\$.near.eye_right') > 0.05")" = 1 ]
}
check "the own template of hirame moves the eye around the head" round_the_head

# ---- Text
text_has() {
    morph check wakin --steps 50 >"$work/text"
    cat "$work/text"
    grep -q '^wakin: [0-9]* keys' "$work/text" && grep -q 'near *far *ordinary' "$work/text" &&
        grep -q 'key, where shown alone, missed by *0.0e+00' "$work/text"
}
check 'the text has a table with column names and figures' text_has

# ---- A damaged drawing: the pectoral fins of the third key point backward through the flanks
reports_damage() {
    awk '/^key / { k++ } /^fin / { f = $2 } /^ray / && k == 3 && f == "pectoral" { $4 = 150; $5 = 0 } { print }' \
        "$root/assets/species/wakin.txt" >"$work/sunk.txt"
    morph check "$work/sunk.txt" --steps 200 >"$work/text"
    [ $? = 1 ] || { cat "$work/text"; return 1; }
    grep -q '^check failed (near): fin deeper than its root.* at progress .* (pectoral)' "$work/text"
}
check 'a damaged drawing fails, and the error names the flaw and its position' reports_damage

refused() { # WORDS...: Wrong usage: exit code 2, one line on standard error, nothing on standard output.
    morph check "$@" >"$work/out" 2>"$work/err"
    [ $? = 2 ] && [ "$(wc -l <"$work/err")" = 1 ] && [ ! -s "$work/out" ]
}
check '--steps 0 is wrong usage' refused wakin --steps 0
check 'an unknown species is wrong usage' refused carp
check 'a missing species is wrong usage' refused
echo "1..$count"
