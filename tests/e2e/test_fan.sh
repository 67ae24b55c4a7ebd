#!/bin/bash
# test_fan.sh -- the real kiosk, a real key and pointer: a fan over the water while F is held.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/lib.sh"
recording=$work/fan.kgr

open_screen
start_kiosk --seed 5 --record "$recording"
ok $? 'the kiosk opens its window and shows a picture' "$work/err" || { done_testing; exit 1; }

# Where the pointer leads it, the leaf's upper part lies 180 px higher on the screen. Paper is bright
# in every colour; water has no red, and a white fish is smaller than what is looked at.
paper_at() { # X Y: 1 when that part of the screen is paper
    import -silent -window root -crop "80x24+$1+$2" miff:- 2>/dev/null |
        convert miff:- -resize '1x1!' -format '%[fx:min(r,b)>0.72]' info:-
}
wait_for() { # 0|1 X Y: up to 10 s. The hand waves a little: a fan at rest is seen through.
    for i in $(seq 40); do
        [ "$(paper_at "$2" "$3")" = "$1" ] && return 0
        xdotool mousemove_relative -- $((i % 2 ? 16 : -16)) 0
        sleep 0.25
    done
    return 1
}

wait_for 0 470 250 && wait_for 0 670 250
ok $? 'there is water where no fan is'
xdotool mousemove 560 430 keydown f
wait_for 1 470 250
ok $? 'F brings a fan over the water'
import -window root "$BUILD/results/fan.png" 2>/dev/null
xdotool mousemove 760 430
wait_for 1 670 250 && wait_for 0 470 250
ok $? 'it follows the pointer'
xdotool keyup f
wait_for 0 670 250
ok $? 'and it goes when F is let go'

quit_by_key
end_of_kiosk 20
ok "$code" 'Escape twice ends the kiosk with code 0' "$work/err"
[ ! -s "$work/err" ]
ok $? 'and it had nothing to complain about' "$work/err"
"$BUILD/kingyoctl" replay verify "$recording" >"$work/verify" 2>&1
ok $? 'the recording, fan and all, verifies without a screen' "$work/verify"
done_testing
