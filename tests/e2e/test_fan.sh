#!/bin/bash
# test_fan.sh -- the real kiosk with a real key and pointer: while F is held, a fan is over the
# water.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"
recording=$work/fan.kgr

open_screen
start_kiosk --seed 5 --record "$recording"
ok $? 'the kiosk opens its window and shows a picture' "$work/err" || { done_testing; exit 1; }

# The upper part of the fan lies 180 px above the pointer on the screen. Paper is bright in every
# colour. Water has no red, and a white fish is smaller than the measured part of the screen.
paper_at() { # X Y: Prints 1 if that part of the screen is paper.
    import -silent -window root -crop "80x24+$1+$2" miff:- 2>/dev/null |
        convert miff:- -resize '1x1!' -format '%[fx:min(r,b)>0.72]' info:-
}
wait_for() { # Waits up to 10 s.
    for _ in $(seq 40); do
        [ "$(paper_at "$2" "$3")" = "$1" ] && return 0
        sleep 0.25
    done
    return 1
}

wait_for 0 470 250 && wait_for 0 670 250
ok $? 'the screen shows water where no fan is'
xdotool mousemove 560 430 keydown f
wait_for 1 470 250
ok $? 'the F key shows a fan over the water'
import -window root "$BUILD/results/fan.png" 2>/dev/null
xdotool mousemove 760 430
wait_for 1 670 250 && wait_for 0 470 250
ok $? 'the fan follows the pointer'
xdotool keyup f
wait_for 0 670 250
ok $? 'the fan disappears when F is released'

quit_by_key
end_of_kiosk 20
ok "$code" 'two presses of Escape end the kiosk with code 0' "$work/err"
[ ! -s "$work/err" ]
ok $? 'standard error is empty' "$work/err"
"$BUILD/kingyoctl" replay verify "$recording" >"$work/verify" 2>&1
ok $? 'the recording with the fan verifies without a screen' "$work/verify"
done_testing
