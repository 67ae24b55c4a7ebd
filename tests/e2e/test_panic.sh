#!/bin/bash
# test_panic.sh -- fatal signals and a panic of the core end the real kiosk. Each leaves a replay
# that ends in the same tick, and each is counted. No credit is lost. The start after three panics
# ignores the settings. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"
ctl=$BUILD/kingyoctl data=$work/data
mkdir "$work/run" # The kiosk creates the data folder.
export RUNTIME_DIRECTORY=$work/run
open_screen

opens() { # OPTIONS...: Returns when the status is written, which is after the first frame.
    rm -f "$work/run/status.json"
    "$BUILD/kingyo" --window 640x360 --lang en --data "$data" --poi bot --seed 5 "$@" >"$work/out" 2>"$work/err" &
    kiosk_pid=$!
    for _ in $(seq 300); do
        [ -s "$work/run/status.json" ] && sleep 0.5 && return 0
        sleep 0.1
    done
    return 1
}
panic_tick() { sed -n 's/.*panic: .*: the game before tick \([0-9]*\) is in .*/\1/p' "$work/err"; }
ends_by() { # SIGNAL STATUS: STATUS is the exit status that the shell reports for the signal.
    { kill -"$1" "$kiosk_pid" && end_of_kiosk 20; } 2>"$work/output"
    [ "$code" -eq "$2" ] && [ "$(grep -c "panic: SIG$1: the game before tick" "$work/err")" -eq 1 ]
}
is_true() { # FILE: The replay verifies, and its length is the tick that the kiosk reported.
    "$ctl" replay verify "$1" >"$work/output" && # A signal from another process may arrive within a tick.
        grep -qE ": true(: $(panic_tick) ticks| up to tick $(panic_tick), in which a signal ended)" "$work/output"
}
# PANICS PARTS: The status reports the numbers. A busy machine reads the count up to 10 s later.
counted() {
    for _ in $(seq 50); do
        "$ctl" status --file "$work/run/status.json" | grep -q "panics  *$1; left out because of them: $2\$" && return 0
        sleep 0.2
    done
    return 1
}

opens && ends_by SEGV 139
ok $? 'SIGSEGV ends the kiosk, and one line gives the tick' "$work/err"
is_true "$data/panic-0.kgr"
ok $? 'the replay after SIGSEGV ends with that tick and the recorded state' "$work/output"
[ "$(stat -c %a "$data/panic-0.kgr" "$data/panics" | sort -u)" = 600 ]
ok $? 'only the owner can read the replay and the count'

status_has() { # TEXT...: Waits up to 60 s until the status contains each text.
    for text in "$@"; do
        for _ in $(seq 300); do
            grep -qF -- "$text" "$work/run/status.json" 2>/dev/null && continue 2
            sleep 0.2
        done
        return 1
    done
}

if command -v gdb >"$work/which"; then
    paid=(--keyboard on --mode festival --coins 1 --fish 12)
    opens "${paid[@]}"
    xdotool key 5 && status_has '"paid": 1' && xdotool key 5 && status_has '"paid": 2' '"waiting": 0' &&
        xdotool key space && status_has '"phase": "round"' '"round_open": true' '"paid": 1' '"waiting": 0'
    ok $? 'two coins are two credits, and a round takes one of them' "$work/run/status.json"
    # The core asserts that the position of the fan is finite, and no driver reports any other
    # position.
    timeout 120 gdb -q -batch -p "$kiosk_pid" -ex 'handle SIGABRT nostop noprint pass' -ex 'break session_recorder_before' \
        -ex continue -ex 'set var ((struct input *)input)->shade[1].present = 1' \
        -ex 'set var ((struct input *)input)->shade[1].x_m = 0.0 / 0.0' -ex delete -ex detach >"$work/gdb" 2>&1
    end_of_kiosk 20 2>"$work/output"
    reason=$(sed -n 's/.*panic: \(core\/.*\): the game before tick .*/\1/p' "$work/err") tick=$(panic_tick)
    [ "$code" -eq 134 ] && [ -n "$reason" ]
    ok $? 'a panic of the core gives its condition and the tick' "$work/gdb"
    "$ctl" replay verify "$data/panic-1.kgr" >"$work/output" 2>&1
    [ $? -eq 1 ] && grep -qF "panic in tick $tick of $((tick + 1)): $reason" "$work/output"
    ok $? 'the replay of the panic panics in that tick for the same reason' "$work/output"
    opens "${paid[@]}"
    status_has '"phase": "attract"' '"paid": 2' '"round_open": false'
    ok $? 'the next start returns the credit of the round' "$work/run/status.json"
    kill "$kiosk_pid" && end_of_kiosk 20
    audits=$("$ctl" audits --json --data "$data")
    grep -qE '"refunds": *1\b' <<<"$audits" && grep -qE '"credits-paid": *2\b' <<<"$audits"
    ok $? 'the audits count two paid credits and one refund'
else
    opens && ends_by BUS 135
    ok $? 'SIGBUS ends the kiosk (gdb is missing, so the core panic is not tested)' "$work/err"
fi
opens && counted 2 nothing
ok $? 'the status counts two panics' "$work/run/status.json"
ends_by FPE 136 && is_true "$data/panic-2.kgr"
ok $? 'SIGFPE leaves a valid replay' "$work/output"

sqlite3 "$data/kingyo.db" 'select count(*) from entries' >"$work/entries"
opens && grep -q 'after three panics within ten minutes this start leaves out settings' "$work/err" && counted 3 settings
ok $? 'the start after three panics ignores the settings, and reports this in log and status' "$work/err"
[ -s "$data/kingyo.db.left-out-1" ] && [ "$(cat "$work/entries")" -le "$(sqlite3 "$data/kingyo.db" 'select count(*) from entries')" ]
ok $? 'the previous database is kept, and no entry of the ledger is lost'
for _ in 3 4 5; do ends_by ABRT 134 && opens; done
grep -q 'leaves out settings and replays' "$work/err"
ok $? 'the start after six panics also ignores the replays' "$work/err"
panics() { od -An -tu4 -j8 -N4 "$data/panics" | tr -d ' '; }
kill "$kiosk_pid" && end_of_kiosk 20
[ "$code" -eq 0 ] && [ "$(panics)" -eq 6 ]
ok $? 'a normal end is not counted as a panic' "$work/err"
# A page for a PIN ends the recording, so the log must give the tick at which the file ends.
data=$work/pin
opens --keyboard on --set pin=1234 && xdotool key F2 && sleep 1.5 && kill -SEGV "$kiosk_pid" && end_of_kiosk 20 2>"$work/output"
ended=$(panic_tick) came=$(sed -n 's/.*panic: SIGSEGV: .*; the panic came in tick \([0-9]*\)$/\1/p' "$work/err")
"$ctl" replay verify "$data/panic-0.kgr" >"$work/output" && grep -q ": true: $ended ticks" "$work/output" && [ "$came" -gt "$ended" ]
ok $? 'the log gives the tick at which a page for a PIN ended the replay' "$work/err"
done_testing
