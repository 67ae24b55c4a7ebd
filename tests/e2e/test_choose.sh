#!/bin/bash
# test_choose.sh -- a visitor starts the real kiosk, chooses a level with a real pointer and dips.
# From START to the first dip in the round the visitor makes one choice and needs at most 8 s.
# tests/vm/state_writer runs the core on the recording and prints the times in ticks of the game.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"
recording=$work/choose.kgr values=$work/values
limit_ms=8000
easy='178 340' water='640 330' # Middle of the tag with the child, and of the water.
attract=0 ready=1 select=5 level_easy=2 # Values of enum scene_phase and of enum level.
: >"$values"

value_of() { # NAME: Prints the latest value of NAME from tests/vm/state_writer, or 0 before the first value.
    awk -v name="$1" '$1 == name { value = $2 } END { print value + 0 }' "$values"
}
becomes() { # NAME VALUE: Waits up to 60 s until NAME has VALUE.
    for _ in $(seq 300); do
        [ "$(value_of "$1")" -eq "$2" ] && return 0
        sleep 0.2
    done
    echo "# $1 is $(value_of "$1"), not $2"
    return 1
}

open_screen
start_kiosk --seed 5 --fish 40 --record "$recording"
ok $? 'the kiosk opens' "$work/err" || { done_testing; exit 1; }
"$BUILD/tests/vm/state_writer" "$recording" "$values" 2>"$work/state_writer.log" &
writer_pid=$!
disown "$writer_pid"
trap 'kill "$writer_pid" 2>/dev/null; leave' EXIT
xdotool mousemove 640 690 # Moves the pointer away from all tags.
becomes link 2 && [ "$(value_of phase)" -eq $attract ]
ok $? 'the kiosk starts in attract mode' "$values"

# The visitor presses START, points at the child and clicks there. Each step waits for the recording,
# because a busy machine draws less than one picture a second.
# shellcheck disable=SC2086  # each place is two words
{
    xdotool key space
    becomes phase $select
    xdotool mousemove $easy
    becomes level $level_easy
    xdotool mousedown 1
    becomes phase $ready
    xdotool mouseup 1 mousemove $water
    # The round begins after three seconds. Clicks before the start have no effect.
    for _ in $(seq 60); do
        xdotool mousedown 1 sleep 0.2 mouseup 1 sleep 0.3
        [ "$(value_of dip_ms)" -gt 0 ] && break
    done
}
becomes level $level_easy
ok $? 'the visitor plays at the level of the picture' "$values"
[ "$(value_of start)" -eq 1 ] && [ "$(value_of rounds)" -eq 1 ]
ok $? 'one press of START and one choice begin the round' "$values"
taken_ms=$(($(value_of dip_ms) - $(value_of start_ms)))
echo "# $taken_ms ms from START to the first dip"
[ "$(value_of dip_ms)" -gt 0 ] && [ "$taken_ms" -le $limit_ms ]
ok $? "the first dip is at most $limit_ms ms after START" "$values"
[ "$(value_of phase)" -ne $select ] && [ "$(value_of differs_at)" -eq 0 ]
ok $? 'the recording reproduces the round' "$values"

quit_by_key
end_of_kiosk 20
ok "$code" 'two presses of Escape end the kiosk with code 0' "$work/err"
done_testing
