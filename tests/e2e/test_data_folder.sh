#!/bin/bash
# test_data_folder.sh -- the real kiosk when its data folder is removed, or contains entries that
# are not files. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"
mkdir "$work/run"
export RUNTIME_DIRECTORY=$work/run
open_screen

status() { "$BUILD/kingyoctl" status --file "$work/run/status.json" >"$work/output" 2>&1; }

begin() { # Waits until the kiosk writes its status, up to 60 s on a busy machine.
    rm -f "$work/run/status.json"
    "$BUILD/kingyo" --window 320x240 --lang en --coins 1 --data "$work/data" >"$work/out" 2>"$work/err" &
    kiosk_pid=$!
    for _ in $(seq 300); do
        status && return 0
        grep -q 'NOT WELL' "$work/output" && return 1
        sleep 0.2
    done
    return 1
}

stop() {
    kill "$kiosk_pid"
    for _ in $(seq 150); do
        kill -0 "$kiosk_pid" 2>/dev/null || break
        sleep 0.1
    done
    wait "$kiosk_pid"
    code=$?
    kiosk_pid=''
}

not_well() { # SECONDS: Waits up to SECONDS until the status is not well.
    for _ in $(seq $(($1 * 5))); do
        status || return 0
        sleep 0.2
    done
    return 1
}

begin
ok $? 'the kiosk is well with a new data folder' "$work/output"
sleep 2
rm -rf "$work/data"
not_well 5
grep -q 'NOT WELL' "$work/output" && grep -q 'removed or replaced' "$work/output" &&
    grep -q 'cannot save what it earns' "$work/output"
ok $? 'the status reports a deleted data folder' "$work/output"
status
[ $? -eq 1 ]
ok $? 'kingyoctl status exits with 1 for a deleted data folder' "$work/output"
stop
[ $code -eq 0 ] && [ -s "$work/data/kingyo.db.backup" ]
ok $? 'the kiosk ends with code 0 and leaves a backup of all entries' "$work/err"
grep -q 'data folder was removed' "$work/err" &&
    grep -q 'all entries are saved in .*/kingyo.db.backup$' "$work/err"
ok $? 'the log reports the removed folder and the backup' "$work/err"
begin
ok $? 'the next start restores the backup' "$work/output"
grep -q 'kingyo.db was missing' "$work/output"
ok $? 'the status reports the missing database' "$work/output"
mv "$work/data" "$work/away"
not_well 5
ok $? 'the status reports a renamed data folder' "$work/output"
mv "$work/away" "$work/data"
for _ in $(seq 50); do status && break; sleep 0.2; done
status
ok $? 'the data folder is used again after the rename is undone' "$work/output"
grep -q 'kingyo.db: is in use again' "$work/err"
ok $? 'the log reports that the database is in use again' "$work/err"
rm "$work/data/kingyo.db-wal"
not_well 5
grep -q 'removed or replaced' "$work/output"
ok $? 'the status reports a deleted write-ahead log' "$work/output"
for _ in $(seq 50); do status && [ -e "$work/data/kingyo.db-wal" ] && break; sleep 0.2; done
status && [ -e "$work/data/kingyo.db-wal" ]
ok $? 'the database is opened again with a new write-ahead log' "$work/output"
grep -q 'kingyo.db: its log .* was removed' "$work/err" &&
    grep -q 'kingyo.db: is in use again, with entries up to' "$work/err"
ok $? 'the log reports the deleted write-ahead log and the new start of the database' "$work/err"
stop
for name in kingyo.db.backup kingyo.db.tail kingyo.db-wal kingyo.db-journal kingyo.db panics usb.txt; do
    rm -f "$work/data/$name"
    mkfifo "$work/data/$name"
done
begin
ok $? 'the kiosk starts with a FIFO in place of each of its files' "$work/err"
grep -qE 'set aside|damaged' "$work/output"
ok $? 'the status reports the renamed FIFOs' "$work/output"
for name in kingyo.db.backup kingyo.db.tail kingyo.db-wal kingyo.db-journal; do
    grep -q "/$name.other-[0-9]*: was not a regular file, and was set aside" "$work/err" || break
done && ! grep -q 'another list' "$work/err"
ok $? 'the log reports each FIFO as not a regular file' "$work/err"
grep -q 'panics in the data folder: is not a regular file, and was renamed to panics.other-1' "$work/err" &&
    [ -p "$work/data/panics.other-1" ] && [ ! -e "$work/data/panics" ]
ok $? 'a FIFO in place of the panic count is renamed' "$work/err"
grep -q 'usb.txt: is not a regular file' "$work/err" && ! grep -q 'not supported' "$work/err"
ok $? 'a FIFO in place of usb.txt is reported without an error text of the system' "$work/err"
stop
[ $code -eq 0 ]
ok $? 'SIGTERM ends the kiosk with code 0' "$work/err"
rm -rf "$work/data"
mkdir "$work/data"
ln -s /dev/zero "$work/data/kingyo.db"
begin
grep -q 'is a symbolic link' "$work/output" && grep -q 'NOT WELL' "$work/output"
ok $? 'a link in place of the database is reported and not followed' "$work/output"
stop
[ $code -eq 0 ]
ok $? 'SIGTERM ends a kiosk without a database with code 0' "$work/err"

done_testing
