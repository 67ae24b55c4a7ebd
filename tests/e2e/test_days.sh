#!/bin/bash
# test_days.sh -- faults during a day of the kiosk: SIGKILL in a paid round, a frame that hangs, a
# full card, a sound card that appears late. tests/e2e/manager takes the place of the service
# manager.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"
notified=$work/notified status=$work/run/status.json
mkdir -p "$work/data" "$work/run"
: >"$notified"
"$BUILD/tests/e2e/manager" "$work/notify" "$notified" &
manager_pid=$!
disown "$manager_pid"
trap 'kill -CONT "$screen_pid" 2>/dev/null; kill "$manager_pid" 2>/dev/null; leave' EXIT
export NOTIFY_SOCKET=$work/notify WATCHDOG_USEC=2000000 RUNTIME_DIRECTORY=$work/run
export SDL_AUDIODRIVER=disk SDL_DISKAUDIOFILE=$work/card/sound

within() { # SECONDS COMMAND...: Waits until the command succeeds.
    local tries=$(($1 * 5))
    shift
    for _ in $(seq "$tries"); do
        "$@" && return 0
        sleep 0.2
    done
    echo "# never: $*"
    sed 's/^/# /' "$status" 2>/dev/null | head -12
    return 1
}
status_has() { grep -qF -- "$1" "$status" 2>/dev/null; }                       # The status contains TEXT.
beats() { grep -c 'WATCHDOG=1' "$notified"; }
has_more_beats() { [ "$(beats)" -gt "$1" ]; }                             # COUNT
audited() { "$BUILD/kingyoctl" audits --json --data "$work/data" 2>/dev/null | grep -qE "\"$1\": *$2\b"; } # NAME COUNT
opens() { # Starts the kiosk and waits until it reports its first frame to the manager.
    local before
    before=$(grep -c READY=1 "$notified")
    start_ms=$(date +%s%3N)
    # The kiosk inherits this setting, so that a file beyond the limit gives an error and not a
    # signal.
    trap '' XFSZ
    "$BUILD/kingyo" --window 640x360 --lang en --data "$work/data" --keyboard on --mode festival --coins 1 --fish 12 \
        --seed 5 >"$work/out" 2>"$work/err" &
    kiosk_pid=$!
    for _ in $(seq 600); do
        [ "$(grep -c READY=1 "$notified")" -gt "$before" ] && return 0
        sleep 0.1
    done
    return 1
}

# ---- A sound card that appears late
open_screen
opens
ok $? 'the kiosk opens without a sound card' "$work/err"
within 30 status_has '"phase": "attract"' && [ ! -s "$SDL_DISKAUDIOFILE" ]
ok $? 'the kiosk without a sound card is silent'
mkdir "$work/card"
within 60 test -s "$SDL_DISKAUDIOFILE"
ok $? 'a sound card that appears later is used'

# ---- SIGKILL in a paid round
xdotool key 5
within 60 status_has '"paid": 1' && within 60 status_has '"waiting": 0'
ok $? 'a coin gives a credit that is on disk'
xdotool key space
within 60 status_has '"phase": "round"' && within 60 status_has '"round_open": true' && within 60 status_has '"waiting": 0'
ok $? 'the running round is on disk'
kill -KILL "$kiosk_pid"
wait "$kiosk_pid" 2>/dev/null
opens
ok $? 'the kiosk opens again after SIGKILL in a round' "$work/err"
ready_ms=$(awk '/READY=1/ { ms = $1 } END { print ms }' "$notified")
echo "# figure: from kill -9 to attract again: $((ready_ms - start_ms)) ms on this machine as it is loaded now"
within 60 status_has '"phase": "attract"' && within 60 status_has '"paid": 1' && status_has '"round_open": false'
ok $? 'the next start is in attract mode with the credit of the round'
within 60 audited refunds 1
ok $? 'the audits count the returned credit' "$work/err"

# ---- A frame that hangs
seen=$(beats)
within 60 has_more_beats "$seen"
ok $? 'each frame sends a watchdog message'
# The stopped X server accepts no pictures, so the frame that presents one blocks.
kill -STOP "$screen_pid"
sleep 2
seen=$(beats)
sleep 5
[ "$(beats)" -eq "$seen" ]
ok $? 'a frame that hangs sends no watchdog message beyond the deadline' "$notified"
kill -CONT "$screen_pid"
within 60 has_more_beats "$seen"
ok $? 'a frame that continues sends watchdog messages again' "$notified"

# ---- The card is full
# No file may grow beyond 8 KiB. The database then cannot be written, but the status can.
prlimit --pid "$kiosk_pid" --fsize=8192:
xdotool key 5
within 60 status_has '"well": false'
ok $? 'the status reports a full card'
prlimit --pid "$kiosk_pid" --fsize=unlimited:
within 60 status_has '"well": true' && within 60 status_has '"paid": 2' && within 60 status_has '"waiting": 0'
ok $? 'a coin that was inserted while the card was full is saved later'

# ---- Closing time
kill -TERM "$kiosk_pid"
end_of_kiosk 30
[ "$code" -eq 0 ] && audited coins-1 2
ok $? 'a normal end leaves both coins in the audits' "$work/err"
done_testing
