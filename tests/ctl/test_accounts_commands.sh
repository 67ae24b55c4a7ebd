#!/bin/bash
# test_accounts_commands.sh -- kingyoctl scores, audits and backup: what they print, copy, restore and
# reject. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
old=tests/unit/platform/store/files
data=$work/data
mkdir "$data"
cp $old/version-6.db "$data/kingyo.db"

prints() { # PATTERN WORDS...: The output of kingyoctl WORDS matches PATTERN.
    local pattern=$1
    shift
    "$ctl" "$@" --data "$data" | tee "$work/out"
    grep -qE -- "$pattern" "$work/out"
}
ends() { # CODE PATTERN WORDS...: kingyoctl WORDS exits with CODE, and its output or error matches PATTERN.
    local code=$1 pattern=$2 got
    shift 2
    "$ctl" "$@" >"$work/out" 2>&1
    got=$?
    cat "$work/out"
    [ $got -eq "$code" ] && grep -qE -- "$pattern" "$work/out"
}
query() { # EXPRESSION WORDS...: SQL over the JSON output, which is the column j.
    local expression=$1
    shift
    "$ctl" "$@" --data "$data" --json >"$work/json" && cat "$work/json"
    [ "$(sqlite3 :memory: "with file (j) as (select cast(readfile('$work/json') as text)) select $expression from file")" = 1 ]
}
# A copy that contains an object of another program is not a copy of a kiosk's database.
refuses_a_trigger() {
    cp $old/version-6.db "$work/trap.db"
    sqlite3 "$work/trap.db" 'create trigger t before insert on entries begin select raise(ignore); end'
    mkdir -p "$work/trapped"
    ends 65 "trap.db: holds the trigger 't', which is not Kingyo's; use another copy" \
        backup --restore "$work/trap.db" --data "$work/trapped" &&
        [ ! -e "$work/trapped/kingyo.db" ] && cp "$work/trap.db" "$work/trapped/kingyo.db" &&
        ends 65 "holds the trigger 't', which is not Kingyo's; the kiosk replaces" audits --data "$work/trapped" &&
        ends 65 "holds the trigger 't', which is not Kingyo's; the kiosk replaces" scores --data "$work/trapped"
}
# A link or a FIFO in place of the database: the kiosk refuses it too, and the message gives the reason.
names_the_type() {
    local command
    mkdir -p "$work/type"
    for command in audits scores "backup $work/type/copy.db"; do
        rm -f "$work/type/kingyo.db" && ln -s "../data/kingyo.db" "$work/type/kingyo.db"
        # shellcheck disable=SC2086  # several arguments
        ends 74 'type/kingyo.db: is a symbolic link$' $command --data "$work/type" || return 1
        rm "$work/type/kingyo.db" && mkfifo "$work/type/kingyo.db"
        # shellcheck disable=SC2086  # several arguments
        ends 74 'type/kingyo.db: is not a regular file$' $command --data "$work/type" || return 1
    done
}
# The message gives each object's type and name, with escape sequences made visible.
names_what_is_not_ours() {
    local sql content
    mkdir -p "$work/named"
    while IFS='|' read -r sql content; do
        cp $old/version-6.db "$work/trap.db"
        sqlite3 "$work/trap.db" "$(printf '%b' "$sql")" || return 1
        ends 65 "trap.db: holds the $content; use another copy" \
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
# A copy of any version can be restored, with all of its rounds. The version of the file stays the same. The same copy
# with a trigger is refused.
restores_every_version() {
    local version at
    for version in 1 2 3 4 5 6; do
        at=$work/version-$version
        mkdir "$at" && cp "$old/version-$version.db" "$at.db" &&
            ends 0 'is now' backup --restore "$at.db" --data "$at" &&
            [ "$(sqlite3 "$at/kingyo.db" 'pragma user_version; select count(*) > 0 from rounds')" = \
                "$(sqlite3 "$at.db" 'pragma user_version; select 1')" ] && rm "$at/kingyo.db" &&
            sqlite3 "$at.db" 'create trigger t after update on rounds begin delete from rounds; end' &&
            ends 65 "holds the trigger 't', which is not Kingyo's" backup --restore "$at.db" --data "$at" &&
            [ ! -e "$at/kingyo.db" ] || return 1
    done
}
follows_a_named_link() {
    ln -s "$PWD/$old/version-6.db" "$work/link.db"
    mkdir -p "$work/linked"
    ends 0 '9 entries' backup --restore "$work/link.db" --data "$work/linked" && [ ! -L "$work/linked/kingyo.db" ]
}
# The link itself becomes kingyo.db.before-1. The database to which the link leads is unchanged.
replaces_a_link() {
    mkdir -p "$work/target" "$work/links" && cp $old/version-6.db "$work/target/kingyo.db" &&
        ln -s ../target/kingyo.db "$work/links/kingyo.db" && cp "$work/target/kingyo.db" "$work/target/same" &&
        ln -s nowhere "$work/links/kingyo.db.before-1" || return 1
    ends 0 'before-2' backup --restore $old/version-6.db --data "$work/links" &&
        [ -f "$work/links/kingyo.db" ] && [ ! -L "$work/links/kingyo.db" ] && [ -L "$work/links/kingyo.db.before-1" ] &&
        [ "$(readlink "$work/links/kingyo.db.before-2")" = ../target/kingyo.db ] &&
        cmp "$work/target/kingyo.db" "$work/target/same" && [ "$(cd "$work/target" && echo *)" = 'kingyo.db same' ]
}
# Another user replaces the data folder by a symbolic link while the copy is written.
stays_in_its_folder() {
    mkdir -p "$work/foreign" "$work/swapped" && cp $old/version-6.db "$work/swapped/kingyo.db" &&
        echo precious | tee "$work/foreign/kingyo.db" >"$work/foreign/kingyo.db.new" &&
        ${CC:-gcc} -shared -fPIC -o "$work/swap.so" tests/ctl/swap_folder.c || return 1
    SWAP_FOLDER=$work/swapped SWAP_TARGET=$work/foreign LD_PRELOAD=$work/swap.so \
        "$ctl" backup --restore $old/version-6.db --data "$work/swapped"
    ls "$work/foreign" "$work/swapped.moved"
    [ -L "$work/swapped" ] && [ "$(cd "$work/foreign" && echo * && cat ./*)" = $'kingyo.db kingyo.db.new\nprecious\nprecious' ] &&
        [ "$(cd "$work/swapped.moved" && echo *)" = 'kingyo.db kingyo.db.before-1' ]
}
is_copy() {
    "$ctl" backup "$work/copy.db" --data "$data" && [ "$(echo "$work/copy.db"*)" = "$work/copy.db" ] &&
        [ "$(sqlite3 "$work/copy.db" 'pragma integrity_check; select count(*) from entries')" = $'ok\n9' ]
}
keeps_other_files() { # A backup leaves files of other programs beside it unchanged.
    echo precious >"$work/own.db-part" && echo precious >"$work/own.db.part"
    "$ctl" backup "$work/own.db" --data "$data" && [ "$(cat "$work/own.db-part" "$work/own.db.part")" = $'precious\nprecious' ]
    local result=$?
    rm -f "$work"/own.db*
    return $result
}
is_utf8() { # The JSON output is UTF-8 whatever the name of the file.
    "$ctl" backup "$work/"$'a\xff\x7f.db' --data "$data" --json >"$work/json" || return 1
    rm "$work/"$'a\xff\x7f.db'
    iconv -f UTF-8 -t UTF-8 "$work/json" >"$work/out" && grep -qF $'a\xef\xbf\xbd\\u007f.db"' "$work/out"
}
keeps() { # FILE PATTERN: A backup to FILE is refused, and FILE is unchanged.
    echo precious >"$1"
    ends 2 "$2" backup "$1" --data "$data" && [ "$(cat "$1")" = precious ]
    local result=$?
    [ "$1" = "$work/precious" ] || rm "$1"
    return $result
}
last_id() { # FILE: Prints the id of the newest ledger entry in the database FILE.
    sqlite3 "$1" 'select max(id) from entries'
}
# The kiosk's database has reached entry 10 since the copy was made. Its backup and its mirror file
# have reached entry 10 as well. If a restore left either file in place, the next start would take
# the restored copy for a file that lost entries, and would undo the restore.
goes_back() {
    mkdir "$work/back" && cp $old/version-6.db "$work/copy-9.db" && cp "$work/copy-9.db" "$work/back/kingyo.db" &&
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
keeps_its_file() { # FILE PATTERN: Restoring FILE fails with an error of PATTERN and leaves kingyo.db unchanged.
    head -c 6000 "$work/copy-9.db" >"$work/torn.db"
    "$ctl" backup --restore "$1" --data "$work/back" >"$work/out" 2>&1 && return 1
    cat "$work/out"
    grep -q -- "$2" "$work/out" && [ "$(last_id "$work/back/kingyo.db")" = 9 ] &&
        [ ! -e "$work/back/kingyo.db.before-3" ] && [ ! -e "$work/back/kingyo.db.new" ]
}
leaves_no_half_copy() {
    ends 65 'damaged' backup "$work/none.db" --data "$work/broken" && ! ls "$work"/none.db* 2>/dev/null
}
# Runs as another user if the test runs as root. Otherwise mode 000 denies the access to the user
# who runs the test.
is_private() {
    local as=()
    [ "$(id -u)" != 0 ] || as=(setpriv --reuid 65534 --regid 65534 --clear-groups)
    mkdir -m 000 "$work/shut" && "${as[@]}" "$ctl" scores --data "$work/shut" >"$work/out" 2>&1
    [ $? -eq 74 ] && grep -q 'use sudo' "$work/out"
}

is_reported_damaged() {
    "$ctl" scores verify 6 --json --data "$data" >"$work/json"
    [ $? -eq 1 ] && [ "$(sqlite3 :memory: "select json_extract(cast(readfile('$work/json') as text), '\$[0].verdict')")" = damaged ]
}
takes_out() {
    "$ctl" scores replay 6 -o "$work/6.kgr" --with-pin --data "$data" &&
        [ "$(sqlite3 "$data/kingyo.db" 'select hex(bytes) from replays where round = 6')" = \
            "$(od -An -v -tx1 "$work/6.kgr" | tr -d ' \n' | tr a-f A-F)" ]
}

check 'scores lists each entry with day, round, name and replay' \
    prints '^ +1 +5 fish +2026-11-21 +round 6 +seat 1 +replay +きんぎょ$' scores --mode festival --period ever
check 'scores verify reports an invalid replay with its round' ends 1 '^round 6: damaged: byte 6: ' scores verify 6 --data "$data"
check 'scores verify --all checks all replays' ends 1 '^round 6: damaged' scores verify --all --data "$data"
check 'scores verify --json reports the verdict' is_reported_damaged
check 'scores replay refuses a damaged replay, which may contain a PIN' ends 1 'may hold the PIN' \
    scores replay 6 -o "$work/none" --data "$data"
check 'scores replay --with-pin extracts a replay unchanged' takes_out
check 'scores verify of a round without a replay exits with 1' ends 1 '^round 5: no replay' scores verify 5 --data "$data"
check 'scores replay of a round without a replay exits with 1' ends 1 'no replay' scores replay 5 -o "$work/none" --data "$data"
check 'scores replay to a file that cannot be written exits with 74' ends 74 'cannot be written' scores replay 6 -o /proc/none --with-pin --data "$data"
check 'scores verify without a round is wrong usage' ends 2 'ROUND or --all' scores verify
check 'scores verify with both a round and --all is wrong usage' ends 2 'ROUND or --all' scores verify 6 --all
check 'scores verify with a surplus argument is wrong usage' ends 2 'not understood' scores verify 6 7
check 'scores replay without -o is wrong usage' ends 2 'ROUND and -o' scores replay 6
check 'scores --mode and --period select one leaderboard' query \
    "json_array_length(j) = 2 and json_extract(j, '\$[0].name') = 'きんぎょ' and json_extract(j, '\$[1].seat') = 2" \
    scores --period week
check 'scores --level selects the leaderboards of a level' query \
    "json_array_length(j) > 0 and json_extract(j, '\$[0].level') = 'master'" scores --level master
check 'a level without scores has empty leaderboards' query "json_array_length(j) = 0" scores --level easy
check 'a link or a FIFO in place of the database is named' names_the_type
check 'scores --level refuses an unknown level' ends 2 'master, normal or easy' scores --level hard
check 'audits counts the rounds at each level' query \
    "json_extract(j, '\$.audits.\"rounds-master\"') + json_extract(j, '\$.audits.\"rounds-easy\"') = json_extract(j, '\$.audits.rounds')" audits
check 'a leaderboard without entries is empty' query "json_array_length(j) = 0" scores --mode championship
check 'audits prints a table' prints '^  caught +7$' audits
check 'the table of audits shows the credits in the machine' prints '^9 entries, start 2; in the machine: paid credits 2, service credits 1, units' audits
check 'audits --json prints one object' query \
    "json_extract(j, '\$.audits.caught') = 7 and json_extract(j, '\$.entries') = 9" audits
check 'a backup is one complete file' is_copy
check 'a backup removes no file but its own temporary file' keeps_other_files
check 'the JSON of a backup replaces the invalid UTF-8 of a file name' is_utf8
check 'a backup replaces an older backup' is_copy
mkdir "$work/of-copy" && mv "$work/copy.db" "$work/of-copy/kingyo.db"
check 'kingyoctl reads a backup like the original database' ends 0 'きんぎょ' scores --data "$work/of-copy"
check 'a backup onto the database itself is refused' ends 2 'own database' backup "$data/kingyo.db" --data "$data"
for name in kingyo.db-wal kingyo.db-journal kingyo.db.backup kingyo.db.new; do
    check "a backup onto $name is refused" keeps "$data/$name" 'own database'
done
check 'a backup does not overwrite a file of another kind' keeps "$work/precious" 'not a copy'
sqlite3 "$work/foreign.db" 'create table rounds (number)'
check 'a backup does not overwrite the database of another program'"'"'s database' ends 2 'not a copy' backup "$work/foreign.db" --data "$data"
check 'a backup onto a folder is refused' ends 74 'is a folder' backup "$work" --data "$data"
check 'a restore replaces the database and keeps the previous files' goes_back
check 'a second restore keeps the files of the first restore' goes_back_again
check 'a restore is refused while the database is in use' refuses_while_it_runs
check 'a restore into an empty folder creates a private database' begins_elsewhere
check 'the database of another program cannot be restored' keeps_its_file "$work/foreign.db" \
    "holds the table 'rounds', whose definition is not Kingyo's"
sqlite3 "$work/no-table.db" 'vacuum'
check 'a database without a table cannot be restored' keeps_its_file "$work/no-table.db" 'is not a copy'
check 'a file that is not a database cannot be restored' keeps_its_file "$work/precious" 'not a database'
check 'a damaged copy cannot be restored' keeps_its_file "$work/torn.db" '.'
check 'the database cannot be restored from itself' keeps_its_file "$work/back/kingyo.db" 'own database'
check 'a backup to a path that cannot be written exits with 74' ends 74 'cannot be written' backup /proc/none --data "$data"
check 'scores without a database exits with 74' ends 74 'does not exist' scores --data "$work/nowhere"
check 'the error for an unreadable data folder advises sudo' is_private
mkdir "$work/empty" && sqlite3 "$data/kingyo.db" "vacuum into '$work/empty/kingyo.db'" &&
    sqlite3 "$work/empty/kingyo.db" 'delete from ranking'
check 'scores verify --all of an empty leaderboard exits with 0' ends 0 'no player has caught a fish yet' scores verify --all \
    --data "$work/empty"
mkdir "$work/old" "$work/broken"
cp $old/version-2.db "$work/old/kingyo.db"
check 'audits refuses a database of an earlier version' ends 65 'start the kiosk once' audits \
    --data "$work/old"
check 'audits leaves a database of an earlier version unchanged' cmp $old/version-2.db "$work/old/kingyo.db"
cp $old/version-6.db "$work/broken/kingyo.db"
printf 'x%.0s' {1..4000} | dd of="$work/broken/kingyo.db" bs=1 seek=4096 conv=notrunc status=none
check 'a damaged database gives no backup' leaves_no_half_copy
check 'an unknown option is wrong usage' ends 2 "unknown option '--nonesuch'" audits --nonesuch
check 'an unknown mode is wrong usage' ends 2 'festival, championship or practice' scores --mode tuna

# ---- Only the owner may read the takings and the hash of the PIN
mode_of() { stat -c %a "$1"; }
private() { # The copy is made under a umask that lets everybody read.
    (umask 022; "$ctl" backup "$work/private.db" --data "$data") && [ "$(mode_of "$work/private.db")" = 600 ]
}
check 'a backup is readable only by its owner' private
private_again() { chmod 644 "$work/private.db" && private; }
check 'a backup that replaces a public copy is private' private_again
check 'a copy with a trigger is refused, and the error names the trigger' refuses_a_trigger
check 'the error for a foreign object gives its type and name' names_what_is_not_ours
check 'a copy of every version can be restored, but not with a trigger' restores_every_version
check 'backup --restore follows a symbolic link' follows_a_named_link
check 'backup --restore replaces a symbolic link, not its target' replaces_a_link
check 'backup --restore renames no file in a folder that a link leads to' stays_in_its_folder
check 'backup --restore into a missing folder names the folder and the option' ends 74 \
    'missing/data: does not exist; create it, or name the data folder with --data' \
    backup --restore $old/version-6.db --data "$work/missing/data"
mkfifo "$work/pipe"
check 'a backup onto a FIFO exits with 74' ends 74 'pipe: cannot be written: is not a regular file' backup "$work/pipe" --data "$data"
echo "1..$count"
