#!/bin/bash
# test_books_command.sh -- kingyoctl scores, audits and backup: what the stall keeps, told. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/lib.sh"
old=tests/unit/store
data=$work/data
mkdir "$data"
cp $old/version-3.db "$data/kingyo.db"

says() { # PATTERN WORDS...
    local pattern=$1
    shift
    "$ctl" "$@" --data "$data" | tee "$work/out"
    grep -qE -- "$pattern" "$work/out"
}
ends() { # CODE PATTERN WORDS...
    local code=$1 pattern=$2 got
    shift 2
    "$ctl" "$@" >"$work/out" 2>&1
    got=$?
    cat "$work/out"
    [ $got -eq "$code" ] && grep -qE -- "$pattern" "$work/out"
}
query() { # EXPRESSION WORDS...: of the JSON, which is j.
    local expression=$1
    shift
    "$ctl" "$@" --data "$data" --json >"$work/json" && cat "$work/json"
    [ "$(sqlite3 :memory: "with file (j) as (select cast(readfile('$work/json') as text)) select $expression from file")" = 1 ]
}
is_copy() {
    "$ctl" backup "$work/copy.db" --data "$data" && [ "$(echo "$work/copy.db"*)" = "$work/copy.db" ] &&
        [ "$(sqlite3 "$work/copy.db" 'pragma integrity_check; select count(*) from entries')" = $'ok\n9' ]
}
leaves_no_half_copy() {
    ends 65 'damaged' backup "$work/none.db" --data "$work/broken" && ! ls "$work"/none.db* 2>/dev/null
}
# As another user, where we are root; else the folder is shut to ourselves.
is_shut_to_others() {
    local as=()
    [ "$(id -u)" != 0 ] || as=(setpriv --reuid 65534 --regid 65534 --clear-groups)
    mkdir -m 000 "$work/shut" && "${as[@]}" "$ctl" scores --data "$work/shut" >"$work/out" 2>&1
    [ $? -eq 74 ] && grep -q 'ask with sudo' "$work/out"
}

is_told_damaged() {
    "$ctl" scores verify 6 --json --data "$data" >"$work/json"
    [ $? -eq 1 ] && [ "$(sqlite3 :memory: "select json_extract(cast(readfile('$work/json') as text), '\$[0].verdict')")" = damaged ]
}
takes_out() {
    "$ctl" scores replay 6 -o "$work/6.kgr" --data "$data" &&
        [ "$(sqlite3 "$data/kingyo.db" 'select hex(bytes) from replays where round = 6')" = \
            "$(od -An -v -tx1 "$work/6.kgr" | tr -d ' \n' | tr a-f A-F)" ]
}

check 'the best are listed with day, round, name and replay' \
    says '^ +1 +5 fish +2026-11-21 +round 6 +seat 1 +replay +きんぎょ$' scores --mode festival --period ever
check 'a replay that is none is told, by round' ends 1 '^round 6: damaged: byte 6: ' scores verify 6 --data "$data"
check 'all replays are looked at' ends 1 '^round 6: damaged' scores verify --all --data "$data"
check 'verdicts are for programs, too' is_told_damaged
check 'a replay is taken out as it is' takes_out
check 'a round without a replay proves nothing' ends 1 '^round 5: no replay' scores verify 5 --data "$data"
check 'nor is anything taken out of it' ends 1 'no replay' scores replay 5 -o "$work/none" --data "$data"
check 'a file that cannot be written is told' ends 74 'cannot be written' scores replay 6 -o /proc/none --data "$data"
check 'verify wants to know which' ends 2 'ROUND or --all' scores verify
check 'not both' ends 2 'ROUND or --all' scores verify 6 --all
check 'a word too many is told' ends 2 'not understood' scores verify 6 7
check 'replay wants a file' ends 2 'ROUND and -o' scores replay 6
check 'a board can be asked for by mode and period' query \
    "json_array_length(j) = 2 and json_extract(j, '\$[0].name') = 'きんぎょ' and json_extract(j, '\$[1].seat') = 2" \
    scores --period week
check 'a board where nobody stands is empty' query "json_array_length(j) = 0" scores --mode championship
check 'the books are a table' says '^  caught +7$' audits
check 'the table has what is in the machine' says '^9 entries, start 2; in the machine: paid credits 2, service credits 1, units' audits
check 'the books are one object' query \
    "json_extract(j, '\$.audits.caught') = 7 and json_extract(j, '\$.entries') = 9" audits
check 'a backup is a whole file of its own' is_copy
check 'a backup may take the place of an older one' is_copy
mkdir "$work/of-copy" && mv "$work/copy.db" "$work/of-copy/kingyo.db"
check 'a backup can be read like the file' ends 0 'きんぎょ' scores --data "$work/of-copy"
check 'a backup never goes onto the file itself' ends 2 'own file' backup "$data/kingyo.db" --data "$data"
log_is_safe() {
    echo log >"$data/kingyo.db-x"
    ends 2 'own file' backup "$data/kingyo.db-x" --data "$data" && [ "$(cat "$data/kingyo.db-x")" = log ]
    local result=$?
    rm "$data/kingyo.db-x"
    return $result
}
precious_is_safe() {
    echo precious >"$work/precious"
    ends 2 'no copy' backup "$work/precious" --data "$data" && [ "$(cat "$work/precious")" = precious ]
}
check 'nor onto what lies beside it under its name' log_is_safe
check 'nor onto what is no copy' precious_is_safe
check 'a folder is no place for a copy' ends 2 'no copy' backup "$work" --data "$data"
check 'a place that cannot be written is told' ends 74 'cannot be written' backup /proc/none --data "$data"
check 'no file at all is told' ends 74 'is not there' scores --data "$work/nowhere"
check 'of a folder that is shut to you sudo is advised' is_shut_to_others
mkdir "$work/empty" && sqlite3 "$data/kingyo.db" "vacuum into '$work/empty/kingyo.db'" &&
    sqlite3 "$work/empty/kingyo.db" 'delete from ranking'
check 'of nobody nothing is verified, and that is said' ends 0 'nobody has caught a fish yet' scores verify --all \
    --data "$work/empty"
mkdir "$work/old" "$work/broken"
cp $old/version-2.db "$work/old/kingyo.db"
check 'a file of an earlier version is not changed by who only looks' ends 65 'start the stall once' audits \
    --data "$work/old"
check 'it is as it was' cmp $old/version-2.db "$work/old/kingyo.db"
cp $old/version-3.db "$work/broken/kingyo.db"
printf 'x%.0s' {1..4000} | dd of="$work/broken/kingyo.db" bs=1 seek=4096 conv=notrunc status=none
check 'of a damaged file no backup is made' leaves_no_half_copy
check 'an unknown word is told' ends 2 "'--nonesuch' is not understood" audits --nonesuch
check 'a mode that there is not is told' ends 2 'festival, championship or practice' scores --mode tuna
echo "1..$count"
