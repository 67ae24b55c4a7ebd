#!/bin/bash
# test_scoop.sh -- a person's evening: the real kiosk on a screen, a real pointer, a goldfish in the bowl.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/lib.sh"
tries_max=60 patience_s=270 # A try takes 2 to 8 s; a poi that tore is changed for another one on the way.
recording=$work/play.kgr

open_screen
# The stall as it opens: 300 fish, a fifth of them within the ring's reach. Our hand lands one in about
# five tries at four to seven pictures a second, on two cores that five to six other programs want too.
start_kiosk --seed 5 --mode festival --record "$recording"
ok $? 'the kiosk opens its window and shows a picture' "$work/err" || { done_testing; exit 1; }
xdotool key space
sleep 4 # Three seconds to take the poi.

# As a person does: find a calm fish, dip beside it, slide under, lift, carry it over (hand.c).
landed=0
for ((i = 0; i < tries_max && landed == 0 && SECONDS < patience_s; i++)); do
    xdotool key space # Another poi where the last one tore; nothing happens in mid-round.
    timeout 30 "$BUILD/tests/e2e/hand" "$window"
    landed=$(caught "$recording")
    landed=${landed:-0}
done
echo "# $landed landed after $i tries"
[ "$landed" -ge 1 ]
ok $? 'a real pointer scoops at least one goldfish into the bowl' "$work/err"

blue=$(shown blue) red=$(shown red) colours=$(shown colours)
echo "# the screen: $colours colours, $blue / 1000 blue, $red / 1000 red"
[ "$colours" -gt 1000 ] && [ "$blue" -gt 100 ] && [ "$red" -gt 5 ]
ok $? 'the screenshot shows a blue tank with red fish in it'
import -window root "$BUILD/results/scoop.png" 2>/dev/null

quit_by_key
end_of_kiosk 20
ok "$code" 'Escape twice ends the kiosk with code 0' "$work/err"
[ ! -s "$work/err" ]
ok $? 'and it had nothing to complain about' "$work/err"
"$BUILD/kingyoctl" replay verify "$recording" >"$work/verify" 2>&1
ok $? 'the recording verifies without a screen' "$work/verify"
[ "$(caught "$recording")" -ge 1 ]
ok $? 'and the whole of it says that a fish was landed' "$work/verify"
done_testing
