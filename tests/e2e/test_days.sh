#!/bin/bash
# test_days.sh -- what a stall meets from morning to night: it is killed in a round that was paid, a frame hangs, the card
# is full for a while, the sound card comes late. A service manager's place is taken by tests/e2e/manager.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/lib.sh"
told=$work/told status=$work/run/status.json
mkdir -p "$work/data" "$work/run"
: >"$told"
"$BUILD/tests/e2e/manager" "$work/notify" "$told" &
manager_pid=$!
disown "$manager_pid"
trap 'kill -CONT "$screen_pid" 2>/dev/null; kill "$manager_pid" 2>/dev/null; leave' EXIT
export NOTIFY_SOCKET=$work/notify WATCHDOG_USEC=2000000 RUNTIME_DIRECTORY=$work/run
export SDL_AUDIODRIVER=disk SDL_DISKAUDIOFILE=$work/card/sound

within() { # SECONDS COMMAND...: until it is so
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
says() { grep -qF -- "$1" "$status" 2>/dev/null; }                       # TEXT of the status
beats() { grep -c 'WATCHDOG=1' "$told"; }
has_more_beats() { [ "$(beats)" -gt "$1" ]; }                             # COUNT
audited() { "$BUILD/kingyoctl" audits --json --data "$work/data" 2>/dev/null | grep -qE "\"$1\": *$2\b"; } # NAME COUNT
opens() { # Starts it, and waits for its first picture, as it tells the manager.
    local before
    before=$(grep -c READY=1 "$told")
    start_ms=$(date +%s%3N)
    trap '' XFSZ # What it inherits: a file that may not grow is an error, not its end.
    "$BUILD/kingyo" --window 640x360 --lang en --data "$work/data" --keyboard on --mode festival --coins 1 --fish 12 \
        --seed 5 >"$work/out" 2>"$work/err" &
    kiosk_pid=$!
    for _ in $(seq 600); do
        [ "$(grep -c READY=1 "$told")" -gt "$before" ] && return 0
        sleep 0.1
    done
    return 1
}

# ---- A sound card that comes late
open_screen
opens
ok $? 'the stall opens without a sound card' "$work/err"
within 30 says '"phase": "attract"' && [ ! -s "$SDL_DISKAUDIOFILE" ]
ok $? 'and is silent'
mkdir "$work/card"
within 60 test -s "$SDL_DISKAUDIOFILE"
ok $? 'a sound card that comes later is found, and plays'

# ---- Killed in a round that was paid
xdotool key 5
within 60 says '"paid": 1' && within 60 says '"waiting": 0'
ok $? 'a coin is a credit, and on disk'
xdotool key space
within 60 says '"phase": "round"' && within 60 says '"round_open": true' && within 60 says '"waiting": 0'
ok $? 'the round runs, and that is on disk'
kill -KILL "$kiosk_pid"
wait "$kiosk_pid" 2>/dev/null
opens
ok $? 'killed in the middle of it, it opens again' "$work/err"
ready_ms=$(awk '/READY=1/ { ms = $1 } END { print ms }' "$told")
echo "# figure: from kill -9 to attract again: $((ready_ms - start_ms)) ms on this machine as it is loaded now"
within 60 says '"phase": "attract"' && within 60 says '"paid": 1' && says '"round_open": false'
ok $? 'in attract, with the credit that the round had cost'
within 60 audited refunds 1
ok $? 'which the books tell as given back' "$work/err"

# ---- A frame that hangs
seen=$(beats)
within 60 has_more_beats "$seen"
ok $? 'each frame says that it lives'
kill -STOP "$screen_pid" # The X server takes no picture any more: the frame that shows one waits for it.
sleep 2
seen=$(beats)
sleep 5
[ "$(beats)" -eq "$seen" ]
ok $? 'a frame that hangs is silent for more than its deadline: the manager would end it' "$told"
kill -CONT "$screen_pid"
within 60 has_more_beats "$seen"
ok $? 'and one that goes on is not' "$told"

# ---- The card is full
# No file may grow beyond 8 KiB: the database cannot be written, the status can.
prlimit --pid "$kiosk_pid" --fsize=8192:
xdotool key 5
within 60 says '"well": false'
ok $? 'a card that takes nothing more is told to whoever watches over the stall'
prlimit --pid "$kiosk_pid" --fsize=unlimited:
within 60 says '"well": true' && within 60 says '"paid": 2' && within 60 says '"waiting": 0'
ok $? 'with room again it has the coin that fell meanwhile'

# ---- Closing time
kill -TERM "$kiosk_pid"
end_of_kiosk 30
[ "$code" -eq 0 ] && audited coins-1 2
ok $? 'and closed in peace both coins are in the books' "$work/err"
done_testing
