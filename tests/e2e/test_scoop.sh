#!/bin/bash
# test_scoop.sh -- a pointer plays the real kiosk on a screen until a goldfish is in the bowl.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"
tries_max=60 patience_s=270 # A try takes 2 to 8 s. A torn poi is replaced between two tries.
recording=$work/play.kgr

open_screen
# The default kiosk has 300 fish, and a fifth of them are within the reach of the ring. The test's
# pointer catches one fish in about five tries at four to seven pictures a second, on two cores
# that five or six other programs share.
start_kiosk --seed 5 --mode festival --record "$recording"
ok $? 'the kiosk opens its window and shows a picture' "$work/err" || { done_testing; exit 1; }
xdotool key space
sleep 4 # The player has three seconds to take the poi.

# The pointer plays like a person (scoop_fish.c): it finds a calm fish, dips beside the fish, slides
# under it, lifts it and carries it to the bowl.
landed=0
for ((i = 0; i < tries_max && landed == 0 && SECONDS < patience_s; i++)); do
    xdotool key space # Space replaces a torn poi, and has no effect during a round.
    timeout 30 "$BUILD/tests/e2e/scoop_fish" "$window"
    landed=$(caught "$recording")
    landed=${landed:-0}
done
echo "# $landed fish caught after $i tries"
[ "$landed" -ge 1 ]
ok $? 'a real pointer scoops at least one goldfish into the bowl' "$work/err"

blue=$(shown blue) red=$(shown red) colours=$(shown colours)
echo "# the screen: $colours colours, $blue / 1000 blue, $red / 1000 red"
[ "$colours" -gt 1000 ] && [ "$blue" -gt 100 ] && [ "$red" -gt 5 ]
ok $? 'the screenshot shows a blue tank with red fish'
import -window root "$BUILD/results/scoop.png" 2>/dev/null

quit_by_key
end_of_kiosk 20
ok "$code" 'two presses of Escape end the kiosk with code 0' "$work/err"
[ ! -s "$work/err" ]
ok $? 'standard error is empty' "$work/err"
"$BUILD/kingyoctl" replay verify "$recording" >"$work/verify" 2>&1
ok $? 'the recording verifies without a screen' "$work/verify"
[ "$(caught "$recording")" -ge 1 ]
ok $? 'the complete recording contains the caught fish' "$work/verify"
done_testing
