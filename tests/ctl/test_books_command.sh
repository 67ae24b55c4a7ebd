#!/bin/bash
# test_books_command.sh -- kingyoctl scores, audits and backup: what the stall keeps, told. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
old=tests/unit/platform/store/files
data=$work/data
mkdir "$data"
cp $old/version-5.db "$data/kingyo.db"

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
refuses_a_trigger() { # A copy with any object that is not ours is no copy of a stall's file.
    cp $old/version-5.db "$work/trap.db"
    sqlite3 "$work/trap.db" 'create trigger t before insert on entries begin select raise(ignore); end'
    mkdir -p "$work/trapped"
    ends 65 "trap.db: holds the trigger 't', which is not Kingyo's; use another copy" \
        backup --restore "$work/trap.db" --data "$work/trapped" &&
        [ ! -e "$work/trapped/kingyo.db" ] && cp "$work/trap.db" "$work/trapped/kingyo.db" &&
        ends 65 "holds the trigger 't', which is not Kingyo's; the stall replaces" audits --data "$work/trapped" &&
        ends 65 "holds the trigger 't', which is not Kingyo's; the stall replaces" scores --data "$work/trapped"
}
names_what_is_not_ours() { # Each kind of object by its type and name, an escape sequence made visible.
    local sql said
    mkdir -p "$work/named"
    while IFS='|' read -r sql said; do
        cp $old/version-5.db "$work/trap.db"
        sqlite3 "$work/trap.db" "$(printf '%b' "$sql")" || return 1
        ends 65 "trap.db: holds the $said; use another copy" \
            backup --restore "$work/trap.db" --data "$work/named" || return 1
        grep -q $'\e' "$work/out" && return 1
    done <<'END'
create view v as select 1|view 'v', which is not Kingyo's
create index i on rounds (seed)|index 'i', which is not Kingyo's
create table "a\033[31mb" (n)|table 'a.+\[31mb', which is not Kingyo's
alter table rounds add column others text|table 'rounds', whose definition is not Kingyo's
END
    [ ! -e "$work/named/kingyo.db" ]
}
follows_a_named_link() {
    ln -s "$PWD/$old/version-5.db" "$work/link.db"
    mkdir -p "$work/linked"
    ends 0 '9 entries' backup --restore "$work/link.db" --data "$work/linked" && [ ! -L "$work/linked/kingyo.db" ]
}
is_copy() {
    "$ctl" backup "$work/copy.db" --data "$data" && [ "$(echo "$work/copy.db"*)" = "$work/copy.db" ] &&
        [ "$(sqlite3 "$work/copy.db" 'pragma integrity_check; select count(*) from entries')" = $'ok\n9' ]
}
spares_a_name() { # What is somebody else's in that folder stays there.
    echo precious >"$work/own.db-part" && echo precious >"$work/own.db.part"
    "$ctl" backup "$work/own.db" --data "$data" && [ "$(cat "$work/own.db-part" "$work/own.db.part")" = $'precious\nprecious' ]
    local result=$?
    rm -f "$work"/own.db*
    return $result
}
is_utf8() { # Whatever the file is called.
    "$ctl" backup "$work/"$'a\xff\x7f.db' --data "$data" --json >"$work/json" || return 1
    rm "$work/"$'a\xff\x7f.db'
    iconv -f UTF-8 -t UTF-8 "$work/json" >"$work/out" && grep -qF $'a\xef\xbf\xbd\\u007f.db"' "$work/out"
}
keeps() { # FILE PATTERN: a backup to FILE is refused, and FILE is as it was.
    echo precious >"$1"
    ends 2 "$2" backup "$1" --data "$data" && [ "$(cat "$1")" = precious ]
    local result=$?
    [ "$1" = "$work/precious" ] || rm "$1"
    return $result
}
last_id() { # FILE
    sqlite3 "$1" 'select max(id) from entries'
}
# The stall has gone on to entry 10 since the copy, and its backup and its second list too: left there, either would
# make of the copy a file that lost something, and the next start would undo it all.
goes_back() {
    mkdir "$work/back" && cp $old/version-5.db "$work/copy-9.db" && cp "$work/copy-9.db" "$work/back/kingyo.db" &&
        chmod 640 "$work/back/kingyo.db" &&
        sqlite3 "$work/back/kingyo.db" 'update entries set id = 10 where id = 9' &&
        cp "$work/back/kingyo.db" "$work/back/kingyo.db.backup" && echo log >"$work/back/kingyo.db-wal" &&
        echo newest >"$work/back/kingyo.db.tail" || return 1
    ends 0 'before-1' backup --restore "$work/copy-9.db" --data "$work/back" || return 1
    ls "$work/back"
    [ "$(last_id "$work/back/kingyo.db")" = 9 ] && [ "$(stat -c %a "$work/back/kingyo.db")" = 640 ] &&
        [ "$(cat "$work/back/kingyo.db.before-1-wal")" = log ] && rm "$work/back/kingyo.db.before-1-wal" &&
        [ "$(cat "$work/back/kingyo.db.before-1.tail")" = newest ] && rm "$work/back/kingyo.db.before-1.tail" &&
        [ "$(last_id "$work/back/kingyo.db.before-1")" = 10 ] &&
        [ "$(last_id "$work/back/kingyo.db.before-1.backup")" = 10 ] &&
        [ "$(cd "$work/back" && echo *)" = 'kingyo.db kingyo.db.before-1 kingyo.db.before-1.backup' ]
}
goes_back_again() {
    ends 0 'before-2' backup --restore "$work/copy-9.db" --data "$work/back" --json &&
        [ "$(last_id "$work/back/kingyo.db.before-1")$(last_id "$work/back/kingyo.db.before-2")" = 109 ]
}
refuses_while_it_runs() {
    local result
    coproc sqlite3 "$work/back/kingyo.db"
    echo 'pragma journal_mode = wal; select count(*) from entries;' >&"${COPROC[1]}"
    read -r _ <&"${COPROC[0]}" && read -r _ <&"${COPROC[0]}"
    ends 74 'stop it first' backup --restore "$work/copy-9.db" --data "$work/back" &&
        [ ! -e "$work/back/kingyo.db.before-3" ] && [ ! -e "$work/back/kingyo.db.new" ]
    result=$?
    echo .quit >&"${COPROC[1]}"
    wait "$COPROC_PID"
    return $result
}
begins_elsewhere() {
    mkdir "$work/other" && ends 0 '9 entries' backup --restore "$work/copy-9.db" --data "$work/other" &&
        [ "$(ls "$work/other")" = kingyo.db ] && [ "$(stat -c %a "$work/other/kingyo.db")" = 600 ]
}
keeps_its_file() { # FILE PATTERN
    head -c 6000 "$work/copy-9.db" >"$work/torn.db"
    "$ctl" backup --restore "$1" --data "$work/back" >"$work/out" 2>&1 && return 1
    cat "$work/out"
    grep -q -- "$2" "$work/out" && [ "$(last_id "$work/back/kingyo.db")" = 9 ] &&
        [ ! -e "$work/back/kingyo.db.before-3" ] && [ ! -e "$work/back/kingyo.db.new" ]
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
check 'a backup removes nothing but what it made itself' spares_a_name
check 'a name that is no UTF-8 is none in JSON' is_utf8
check 'a backup may take the place of an older one' is_copy
mkdir "$work/of-copy" && mv "$work/copy.db" "$work/of-copy/kingyo.db"
check 'a backup can be read like the file' ends 0 'きんぎょ' scores --data "$work/of-copy"
check 'a backup never goes onto the file itself' ends 2 'own file' backup "$data/kingyo.db" --data "$data"
for name in kingyo.db-wal kingyo.db-journal kingyo.db.backup kingyo.db.new; do
    check "nor onto $name" keeps "$data/$name" 'own file'
done
check 'a file that is none of ours is not written over' keeps "$work/precious" 'no copy'
sqlite3 "$work/foreign.db" 'create table rounds (number)'
check 'nor is another program'"'"'s database' ends 2 'no copy' backup "$work/foreign.db" --data "$data"
check 'a folder is told' ends 2 'is a folder' backup "$work" --data "$data"
check 'the stall goes back to a copy, and what was there is kept' goes_back
check 'with the second nothing of the first is lost' goes_back_again
check 'a stall that runs keeps its file' refuses_while_it_runs
check 'another machine begins with a copy' begins_elsewhere
check 'what is no copy takes no place' keeps_its_file "$work/foreign.db" 'is no copy'
check 'nor does what is no database' keeps_its_file "$work/precious" 'not a database'
check 'nor does a damaged one' keeps_its_file "$work/torn.db" '.'
check 'nor the file itself' keeps_its_file "$work/back/kingyo.db" 'own file'
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
cp $old/version-5.db "$work/broken/kingyo.db"
printf 'x%.0s' {1..4000} | dd of="$work/broken/kingyo.db" bs=1 seek=4096 conv=notrunc status=none
check 'of a damaged file no backup is made' leaves_no_half_copy
check 'an unknown word is told' ends 2 "unknown option '--nonesuch'" audits --nonesuch
check 'a mode that there is not is told' ends 2 'festival, championship or practice' scores --mode tuna

# ---- Nobody but the owner reads what holds the takings and the hash of the PIN
mode_of() { stat -c %a "$1"; }
private() { # FILE, made under a umask that lets everybody read
    (umask 022; "$ctl" backup "$work/private.db" --data "$data") && [ "$(mode_of "$work/private.db")" = 600 ]
}
check 'a backup is its owner'\''s alone' private
private_again() { chmod 644 "$work/private.db" && private; }
check 'also where an older copy was everybody'\''s' private_again
check 'a copy with a trigger is refused, and a file with one names it' refuses_a_trigger
check 'each kind of object that is not ours is named by its type and name' names_what_is_not_ours
check 'a link that the user names is followed' follows_a_named_link
echo "1..$count"
