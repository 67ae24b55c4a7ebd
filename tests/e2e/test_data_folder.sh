#!/bin/bash
# test_data_folder.sh -- the real kiosk when its data folder goes, or holds things that are no files. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/lib.sh"
mkdir "$work/run"
export RUNTIME_DIRECTORY=$work/run
open_screen

status() { "$BUILD/kingyoctl" status --file "$work/run/status.json" >"$work/said" 2>&1; }

begin() { # Waits until the kiosk reports: up to 60 s on a busy machine.
    rm -f "$work/run/status.json"
    "$BUILD/kingyo" --window 320x240 --lang en --coins 1 --data "$work/data" >"$work/out" 2>"$work/err" &
    kiosk_pid=$!
    for _ in $(seq 300); do
        status && return 0
        grep -q 'NOT WELL' "$work/said" && return 1
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

not_well() { # SECONDS: waits for it that long.
    for _ in $(seq $(($1 * 5))); do
        status || return 0
        sleep 0.2
    done
    return 1
}

begin
ok $? 'the stall is well with a new data folder' "$work/said"
sleep 2
rm -rf "$work/data"
not_well 5
grep -q 'NOT WELL' "$work/said" && grep -q 'removed or replaced' "$work/said" &&
    grep -q 'is not kept now' "$work/said"
ok $? 'a deleted data folder is reported by status' "$work/said"
status
[ $? -eq 1 ]
ok $? 'which ends with exit code 1' "$work/said"
stop
[ $code -eq 0 ] && [ -s "$work/data/kingyo.db.backup" ]
ok $? 'the kiosk ends normally and leaves a backup of all it had' "$work/err"
grep -q 'data folder was removed' "$work/err" &&
    grep -q 'all entries are saved in .*/kingyo.db.backup$' "$work/err"
ok $? 'and its log names the loss and that backup' "$work/err"
begin
ok $? 'from which the next start goes on' "$work/said"
grep -q 'kingyo.db was missing' "$work/said"
ok $? 'and says so' "$work/said"
mv "$work/data" "$work/away"
not_well 5
ok $? 'a renamed data folder is reported' "$work/said"
mv "$work/away" "$work/data"
for _ in $(seq 50); do status && break; sleep 0.2; done
status
ok $? 'and is used again once it is back' "$work/said"
grep -q 'kingyo.db: is in use again' "$work/err"
ok $? 'and the log says so' "$work/err"
rm "$work/data/kingyo.db-wal"
not_well 5
grep -q 'removed or replaced' "$work/said"
ok $? 'a deleted log of the database is reported' "$work/said"
for _ in $(seq 50); do status && [ -e "$work/data/kingyo.db-wal" ] && break; sleep 0.2; done
status && [ -e "$work/data/kingyo.db-wal" ]
ok $? 'and the database is opened again with a new log' "$work/said"
grep -q 'kingyo.db: its log .* was removed' "$work/err" &&
    grep -q 'kingyo.db: is in use again, with entries up to' "$work/err"
ok $? 'and both are in the log' "$work/err"
stop
for name in kingyo.db.backup kingyo.db.tail kingyo.db-wal kingyo.db-journal kingyo.db panics usb.txt; do
    rm -f "$work/data/$name"
    mkfifo "$work/data/$name"
done
begin
ok $? 'the stall starts with a FIFO in place of each of its files' "$work/err"
grep -qE 'set aside|damaged' "$work/said"
ok $? 'and says so' "$work/said"
for name in kingyo.db.backup kingyo.db.tail kingyo.db-wal kingyo.db-journal; do
    grep -q "/$name.other-[0-9]*: was not a regular file, and was set aside" "$work/err" || break
done && ! grep -q 'another list' "$work/err"
ok $? 'and the log calls none of them a file of another list' "$work/err"
grep -q 'panics in the data folder: is not a regular file, and is now panics.other-1' "$work/err" &&
    [ -p "$work/data/panics.other-1" ] && [ ! -e "$work/data/panics" ]
ok $? 'a FIFO in place of the count of panics is set aside' "$work/err"
grep -q 'usb.txt: is not a regular file' "$work/err" && ! grep -q 'not supported' "$work/err"
ok $? 'and one in place of usb.txt is named without an error text of the system' "$work/err"
stop
[ $code -eq 0 ]
ok $? 'and ends by SIGTERM' "$work/err"
rm -rf "$work/data"
mkdir "$work/data"
ln -s /dev/zero "$work/data/kingyo.db"
begin
grep -q 'is a symbolic link' "$work/said" && grep -q 'NOT WELL' "$work/said"
ok $? 'a link in place of the database is reported and not followed' "$work/said"
stop
[ $code -eq 0 ]
ok $? 'and SIGTERM ends the kiosk there as well' "$work/err"

done_testing
