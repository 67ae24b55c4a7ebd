#!/bin/bash
# test_panic.sh -- fatal signals and a panic of the core end the real kiosk. Each leaves a replay that comes to the same
# tick, each is counted, no credit is lost, and the start after three of them leaves settings out. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/lib.sh"
ctl=$BUILD/kingyoctl data=$work/data
mkdir "$work/run" # The kiosk makes the data folder.
export RUNTIME_DIRECTORY=$work/run
open_screen

opens() { # OPTIONS...: returns when the status is written, which is after the first frame.
    rm -f "$work/run/status.json"
    "$BUILD/kingyo" --window 640x360 --lang en --data "$data" --poi bot --seed 5 "$@" >"$work/out" 2>"$work/err" &
    kiosk_pid=$!
    for _ in $(seq 300); do
        [ -s "$work/run/status.json" ] && sleep 0.5 && return 0
        sleep 0.1
    done
    return 1
}
said_tick() { sed -n 's/.*panic: .*: the game before tick \([0-9]*\) is in .*/\1/p' "$work/err"; }
ends_by() { # SIGNAL STATUS: what the shell calls a process that it ended.
    { kill -"$1" "$kiosk_pid" && end_of_kiosk 20; } 2>"$work/said"
    [ "$code" -eq "$2" ] && [ "$(grep -c "panic: SIG$1: the game before tick" "$work/err")" -eq 1 ]
}
is_true() { # FILE: it verifies, and its length is the tick that the kiosk named.
    "$ctl" replay verify "$1" >"$work/said" && # A signal from outside may come within a tick.
        grep -qE ": true(: $(said_tick) ticks| up to tick $(said_tick), in which a signal ended)" "$work/said"
}
counted() { # PANICS PARTS: the status reports them; a busy machine reads the count up to 10 s later.
    for _ in $(seq 50); do
        "$ctl" status --file "$work/run/status.json" | grep -q "panics  *$1; left out because of them: $2\$" && return 0
        sleep 0.2
    done
    return 1
}

opens && ends_by SEGV 139
ok $? 'SIGSEGV ends the kiosk and names the tick in one line' "$work/err"
is_true "$data/panic-0.kgr"
ok $? 'its replay ends with that tick, and its last state agrees' "$work/said"
[ "$(stat -c %a "$data/panic-0.kgr" "$data/panics" | sort -u)" = 600 ]
ok $? 'only the owner can read the replay and the count'

status_has() { # TEXT...: the status has each text within 60 s.
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
    # The core asserts that the fan is at a finite place, and no driver reports any other place.
    timeout 120 gdb -q -batch -p "$kiosk_pid" -ex 'handle SIGABRT nostop noprint pass' -ex 'break session_recorder_before' \
        -ex continue -ex 'set var ((struct input *)input)->shade[1].present = 1' \
        -ex 'set var ((struct input *)input)->shade[1].x_m = 0.0 / 0.0' -ex delete -ex detach >"$work/gdb" 2>&1
    end_of_kiosk 20 2>"$work/said"
    reason=$(sed -n 's/.*panic: \(core\/.*\): the game before tick .*/\1/p' "$work/err") tick=$(said_tick)
    [ "$code" -eq 134 ] && [ -n "$reason" ]
    ok $? 'a panic of the core names its condition and the tick' "$work/gdb"
    "$ctl" replay verify "$data/panic-1.kgr" >"$work/said" 2>&1
    [ $? -eq 1 ] && grep -qF "panic in tick $tick of $((tick + 1)): $reason" "$work/said"
    ok $? 'its replay panics in that tick for the same reason' "$work/said"
    opens "${paid[@]}"
    status_has '"phase": "attract"' '"paid": 2' '"round_open": false'
    ok $? 'no credit is lost: the next start returns the credit of the round' "$work/run/status.json"
    kill "$kiosk_pid" && end_of_kiosk 20
    audits=$("$ctl" audits --json --data "$data")
    grep -qE '"refunds": *1\b' <<<"$audits" && grep -qE '"credits-paid": *2\b' <<<"$audits"
    ok $? 'the audits count two paid credits and one refund'
else
    opens && ends_by BUS 135
    ok $? 'SIGBUS ends the kiosk (a panic of the core needs gdb, which is not here)' "$work/err"
fi
opens && counted 2 nothing
ok $? 'status counts two panics' "$work/run/status.json"
ends_by FPE 136 && is_true "$data/panic-2.kgr"
ok $? 'SIGFPE leaves a true replay as well' "$work/said"

sqlite3 "$data/kingyo.db" 'select count(*) from entries' >"$work/entries"
opens && grep -q 'after three panics within ten minutes this start leaves out settings' "$work/err" && counted 3 settings
ok $? 'the start after three panics leaves settings out, and tells log and status' "$work/err"
[ -s "$data/kingyo.db.left-out-1" ] && [ "$(cat "$work/entries")" -le "$(sqlite3 "$data/kingyo.db" 'select count(*) from entries')" ]
ok $? 'the database from before lies beside it, and no entry of the ledger is gone'
for _ in 3 4 5; do ends_by ABRT 134 && opens; done
grep -q 'leaves out settings and replays' "$work/err"
ok $? 'after three more the next start leaves replays out, too' "$work/err"
panics() { od -An -tu4 -j8 -N4 "$data/panics" | tr -d ' '; }
kill "$kiosk_pid" && end_of_kiosk 20
[ "$code" -eq 0 ] && [ "$(panics)" -eq 6 ]
ok $? 'an orderly end is no panic' "$work/err"
done_testing
