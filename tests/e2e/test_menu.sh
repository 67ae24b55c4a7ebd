#!/bin/bash
# test_menu.sh -- an operator's evening: the real kiosk on a screen, its coin slot and the two buttons inside the cabinet
# on real keys. Each press waits until the recording has it, and the kiosk's own core, ticked again beside it, says what
# became of it (tests/vm/look): so it holds however slow the machine is. Pictures must show the same.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/lib.sh"
recording=$work/menu.kgr mind=$work/mind
: >"$mind"
attract=0 round=2 menu=8         # enum scene_phase

knows() { # NAME: what the recording's last second says of it; 0 before there is any.
    awk -v name="$1" '$1 == name { value = $2 } END { print value + 0 }' "$mind"
}
becomes() { # NAME VALUE [SECONDS]: waits for it
    for _ in $(seq $((${3:-60} * 5))); do
        [ "$(knows "$1")" -eq "$2" ] && return 0
        sleep 0.2
    done
    echo "# $1 is $(knows "$1"), not $2"
    return 1
}
tap() { # KEY COUNTER: presses it once, and waits until the kiosk has seen that.
    local seen
    seen=$(knows "$2")
    xdotool key "$1"
    becomes "$2" $((seen + 1))
}
point_to() { # NAME of a page, or "back": by SERVICE alone
    for _ in $(seq 16); do
        [ "$(knows tag)" -eq "$(knows "to_$1")" ] && return 0
        tap F3 service || return 1
    done
    return 1
}
go_to() { # PAGE...: one after the other
    local page
    for page; do
        point_to "$page" && tap F2 test && becomes "on_$page" 1 || return 1
    done
}

# The mean colour of a part of the screen, held against a condition in r, g and b of 0 .. 255.
# On a window of 1280x720 the canvas of core/game/pointer_mapping.h is the window.
looks() { # CONDITION WxH+X+Y
    import -silent -window root -crop "$2" miff:- 2>/dev/null | convert miff:- -resize '1x1!' -depth 8 rgb:- |
        od -An -v -tu1 -w3 | awk "{ r = \$1; g = \$2; b = \$3; is_so = ($1) } END { exit !is_so }"
}
shows() { # CONDITION WxH+X+Y: within 30 s
    for _ in $(seq 60); do
        looks "$1" "$2" && return 0
        sleep 0.5
    done
    echo "# $2 never showed $1"
    return 1
}
wood='r > 110 && r > b + 40' night='r < 40 && b < 70' green='g > r + 40' red='r > 120 && g < 70 && b < 70'
tank=400x200+400+250          # The middle of the water; in the menu, under the tags.
tags='60x14+115+254 60x14+730+254 60x14+460+486' # Bare wood between a tag's name and its words.
plate=8x12+562+484            # Left of the word "Credits".
start=12x12+318+607           # The long start ribbon; the call for coins is shorter.
store=8x20+1085+126 refused=8x20+1085+221 # The first two slips of the files' page.
question=200x4+540+136        # Above "TEST once more ends this round".
picture() { # NAME
    import -window root "$BUILD/results/menu_$1.png" 2>/dev/null
}

mkdir -p "$work/data/species"
echo nonsense >"$work/data/species/bad.kfish"
open_screen
start_kiosk --seed 5 --fish 12 --mode festival --coins 2 --record "$recording"
ok $? 'the kiosk opens' "$work/err" || { done_testing; exit 1; }
"$BUILD/tests/vm/look" "$recording" "$mind" 2>"$work/look.log" &
look_pid=$!
disown "$look_pid"
trap 'kill "$look_pid" 2>/dev/null; leave' EXIT
xdotool mousemove 30 700 # A hand that rests over no tag.
becomes link 2 && [ "$(knows phase)" -eq $attract ]
ok $? 'and nobody has paid' "$mind"
shows 'b > r + 40 && b > 120' $tank && shows "!($green)" $plate
ok $? 'the tank is blue, and the plate of credits is not lit'

# ---- The menu -----------------------------------------------------------------------------------
tap F2 test && becomes phase $menu && becomes on_top 1
ok $? 'F2 opens the menu' "$mind"
hung=0
for tag in $tags; do
    shows "$wood" "$tag" || hung=1
done
[ $hung -eq 0 ] && shows "$night" 200x30+60+650
ok $? 'wooden tags hang before a tank that lies in the dark'
picture top

go_to devices lines
ok $? 'SERVICE points at the lines, TEST takes them' "$mind"
tap 5 coins && becomes test_coins 1
ok $? 'a coin there is a test of the slot' "$mind"
[ "$(knows fallen)" -eq 0 ] && [ "$(knows credits)" -eq 0 ] && [ "$(knows metered)" -eq 1 ]
ok $? 'which is metered, and no credit nor a part of one' "$mind"
picture lines
tap F2 test && becomes on_devices 1
ok $? 'TEST leads back' "$mind"
tap 5 coins && becomes metered 2 && [ "$(knows fallen)" -eq 0 ] && [ "$(knows credits)" -eq 0 ]
ok $? 'on any other page one that falls is a test as well' "$mind"

point_to back && tap F2 test && becomes on_top 1 && go_to upkeep files
ok $? 'SERVICE points at the files, TEST takes them' "$mind"
[ "$(knows files)" -eq 2 ]
ok $? 'which are two: the store and what somebody put there' "$mind"
shows "$green" $store && shows "$red" $refused
ok $? 'the store is in use, and a species that is none was refused'
picture files
point_to back && tap F2 test && becomes on_upkeep 1
ok $? 'BACK leads back' "$mind"
point_to back && tap F2 test && becomes on_top 1 && point_to back && tap F2 test && becomes phase $attract
ok $? 'the last tag opens the stall' "$mind"
shows 'b > r + 40 && b > 120' $tank
ok $? 'the tank lies in the light again'

# ---- Coins --------------------------------------------------------------------------------------
tap 5 coins && becomes fallen 1 && [ "$(knows credits)" -eq 0 ]
ok $? 'of two coins the first is half a credit' "$mind"
tap space start && sleep 2 && becomes phase $attract && [ "$(knows taken)" -eq 0 ]
ok $? 'for which START begins nothing' "$mind"
shows "!($green)" $plate && shows "!($red)" $start
ok $? 'and the plate of credits is dark'
tap 5 coins && becomes credits 1 && [ "$(knows fallen)" -eq 0 ]
ok $? 'the second makes it whole' "$mind"
[ "$(knows metered)" -eq 4 ]
ok $? 'both are metered, as the tests were' "$mind"
shows "$green" $plate && shows "$red" $start
ok $? 'the plate is lit, and START is called for'
picture paid
tap space start && becomes taken 1 && becomes credits 0
ok $? 'START begins a round and takes the credit' "$mind"
becomes phase $round
ok $? 'which runs' "$mind"

# ---- A round and the elbow ----------------------------------------------------------------------
# It is asked for five seconds: a machine that shows nothing for so long is asked again.
asked=1
for _ in 1 2 3; do
    seen=$(knows test)
    xdotool key F2
    for _ in $(seq 60); do
        looks "$red" $question && asked=0 && break
        [ "$(knows test)" -gt "$seen" ] && [ "$(knows asks)" -eq 0 ] && break
    done
    becomes test $((seen + 1))
    [ $asked -eq 0 ] && break
done
ok $asked 'F2 in a round is answered by a question over the tank' "$mind"
picture asks
becomes asks 0 && [ "$(knows phase)" -eq $round ] && [ "$(knows given_back)" -eq 0 ]
ok $? 'and an elbow ends nothing' "$mind"
shows "!($red)" $question
ok $? 'the question is gone'
for _ in 1 2 3 4; do
    xdotool key F2 sleep 1 key F2 # In one frame they would be one press: then once more.
    becomes phase $menu 10 >/dev/null && break
done
becomes phase $menu && becomes given_back 1 && becomes credits 1
ok $? 'F2 once more ends it: the menu is open, and the credit is back' "$mind"

# ---- The end ------------------------------------------------------------------------------------
xdotool key Escape
becomes phase $attract
ok $? 'Escape in the menu goes back to the stall' "$mind"
xdotool key Escape
sleep 1
import -window root "$BUILD/results/quit.png" 2>/dev/null
kill -0 "$kiosk_pid"
ok $? 'Escape on the attract screen asks first'
quit_by_key
end_of_kiosk 30
ok "$code" 'and Escape once more ends the kiosk with code 0' "$work/err"
grep -q 'species/bad.kfish: magic' "$work/err" && one_line "$work/err"
ok $? 'which had to complain of that species alone' "$work/err"
[ "$(knows differs_at)" -eq 0 ] && [ ! -s "$work/look.log" ]
ok $? "and each tick was the one that its recording's reader computed" "$mind"
"$BUILD/kingyoctl" replay verify "$recording" >"$work/verify" 2>&1
ok $? 'the recording verifies, menu, coins and all' "$work/verify"
done_testing
