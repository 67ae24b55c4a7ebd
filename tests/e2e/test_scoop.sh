#!/bin/bash
# test_scoop.sh -- a person's evening: the real kiosk on a screen, a real pointer, a goldfish in the bowl.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/lib.sh"
tries_max=50 # About 5 s each; a poi that tore is changed for another one on the way.
recording=$work/play.kgr

open_screen
# Six hundred fish, about what the water holds: our hand aims at where a fish was half a second ago, and
# with the festival's 300, which a person follows by eye, lands one in fifteen tries.
start_kiosk --seed 5 --fish 600 --record "$recording"
ok $? 'the kiosk opens its window and shows a picture' "$work/err" || { done_testing; exit 1; }

read -r bowl_x bowl_y < <(place bowl)
xdotool key space
sleep 4 # Three seconds to take the poi.

look() {
    import -silent -window root -depth 8 rgb:-
}

# As a person does: find a calm fish near the middle, dip beside it, slide under, lift while it still
# slides, carry it over. The rectangle keeps clear of the walls and of the bowl.
try() {
    local fish_x fish_y
    xdotool key space # Another poi where the last one tore; nothing happens in mid-round.
    read -r fish_x fish_y < <({ look; look; } | "$BUILD/tests/e2e/eye" 360 200 800 430)
    glide $((fish_x - 80)) "$fish_y" 0.4
    xdotool mousedown 1
    sleep 0.35
    glide $((fish_x + 20)) "$fish_y" 0.35
    xdotool mouseup 1
    sleep 0.8
    glide "$bowl_x" "$bowl_y" 1.0
    sleep 1.0
}

landed=0
for ((i = 0; i < tries_max && landed == 0; i++)); do
    try
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

xdotool key Escape
end_of_kiosk 20
ok "$code" 'Escape ends the kiosk with code 0' "$work/err"
[ ! -s "$work/err" ]
ok $? 'and it had nothing to complain about' "$work/err"
"$BUILD/kingyoctl" replay verify "$recording" >"$work/verify" 2>&1
ok $? 'the recording verifies without a screen' "$work/verify"
[ "$(caught "$recording")" -ge 1 ]
ok $? 'and the whole of it says that a fish was landed' "$work/verify"
done_testing
