#!/bin/bash
# test_menu.sh -- an operator opens the menu, inserts coins and ends a round on the real kiosk.
# Keys stand for the coin slot and the two buttons inside the cabinet. After each press the test
# waits until the recording contains it. tests/vm/state_writer runs the core on the recording and prints
# the resulting state, so the test does not depend on the speed of the machine. Pictures of the
# screen must show the same state.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"
recording=$work/menu.kgr values=$work/values
: >"$values"
attract=0 round=2 menu=8         # Values of enum scene_phase.

value_of() { # NAME: Prints the latest value of NAME from tests/vm/state_writer, or 0 before the first value.
    awk -v name="$1" '$1 == name { value = $2 } END { print value + 0 }' "$values"
}
becomes() { # NAME VALUE [SECONDS]: Waits until NAME has VALUE.
    for _ in $(seq $((${3:-60} * 5))); do
        [ "$(value_of "$1")" -eq "$2" ] && return 0
        kill -0 "$kiosk_pid" 2>/dev/null || break
        sleep 0.2
    done
    echo "# $1 is $(value_of "$1"), not $2"
    return 1
}
tap() { # KEY COUNTER: Presses KEY once and waits until the kiosk has processed the press.
    local seen
    seen=$(value_of "$2")
    xdotool key "$1"
    becomes "$2" $((seen + 1))
}
point_to() { # NAME of a page, or "back": Presses SERVICE until the selection reaches the page or "back".
    for _ in $(seq 16); do
        [ "$(value_of tag)" -eq "$(value_of "to_$1")" ] && return 0
        tap F3 service || return 1
    done
    return 1
}
go_to() { # PAGE...: Opens the pages one after another.
    local page
    for page; do
        point_to "$page" && tap F2 test && becomes "on_$page" 1 || return 1
    done
}

# Compares the mean colour of a part of the screen with a condition on r, g and b of 0 to 255. In a
# window of 1280x720 the canvas of core/game/pointer_mapping.h equals the window.
region_is() { # CONDITION WxH+X+Y
    import -silent -window root -crop "$2" miff:- 2>/dev/null | convert miff:- -resize '1x1!' -depth 8 rgb:- |
        od -An -v -tu1 -w3 | awk "{ r = \$1; g = \$2; b = \$3; is_so = ($1) } END { exit !is_so }"
}
shows() { # CONDITION WxH+X+Y: Waits up to 30 s for the condition.
    for _ in $(seq 60); do
        region_is "$1" "$2" && return 0
        sleep 0.5
    done
    echo "# $2 never showed $1"
    return 1
}
wood='r > 110 && r > b + 40' night='r < 40 && b < 70' green='g > r + 40' red='r > 120 && g < 70 && b < 70'
water='g > r + 15 && g > 80 && b > 80' # The lamplit tank. The menu darkens it.
tank=400x200+400+250          # The middle of the water. In the menu this part is below the tags.
tags='60x14+115+254 60x14+730+254 60x14+460+486' # Wood between a tag's name and its text.
plate=8x12+306+484            # Left of the word "Credits".
start=12x12+34+607            # The long start ribbon. The ribbon that asks for coins is shorter.
store=8x20+1085+126 refused=8x20+1085+221 # The first two rows of the page of files.
question=200x4+540+136        # Above "TEST again ends this round".
picture() { # NAME: Saves a picture of the screen as a result of the test.
    import -window root "$BUILD/results/menu_$1.png" 2>/dev/null
}

mkdir -p "$work/data/species"
echo nonsense >"$work/data/species/bad.kfish"
open_screen
start_kiosk --seed 5 --fish 12 --mode festival --coins 2 --record "$recording"
ok $? 'the kiosk opens' "$work/err" || { done_testing; exit 1; }
"$BUILD/tests/vm/state_writer" "$recording" "$values" 2>"$work/state_writer.log" &
writer_pid=$!
disown "$writer_pid"
trap 'kill "$writer_pid" 2>/dev/null; leave' EXIT
xdotool mousemove 30 700 # Moves the pointer away from all tags.
becomes link 2 && [ "$(value_of phase)" -eq $attract ]
ok $? 'the kiosk starts in attract mode without a credit' "$values"
shows "$water" $tank && shows "!($green)" $plate
ok $? 'the tank is blue-green, and the credit plate is not lit'

# ---- The menu -----------------------------------------------------------------------------------
tap F2 test && becomes phase $menu && becomes on_top 1
ok $? 'F2 opens the menu' "$values"
hung=0
for tag in $tags; do
    shows "$wood" "$tag" || hung=1
done
[ $hung -eq 0 ] && shows "$night" 200x30+60+650
ok $? 'the menu shows wooden tags in front of a dark tank'
picture top

# The two arrows beside a value, pressed with a real pointer. An arrow repeats while it is held, so
# that a long frame may change the value by several steps.
click_arrow() { # lower|raise -lt|-gt: Clicks the arrow until the first value of the page has changed in the direction.
    local before
    before=$(value_of arrow_value)
    xdotool mousemove "$(value_of "$1_x")" "$(value_of arrows_y)"
    for _ in 1 2 3; do
        xdotool mousedown 1 sleep 0.3 mouseup 1
        for _ in $(seq 50); do
            test "$(value_of arrow_value)" "$2" "$before" && return 0
            sleep 0.2
        done
    done
    return 1
}
go_to sound && [ "$(value_of arrow_value)" -eq 80 ]
ok $? 'the page of sound shows the volume' "$values"
click_arrow lower -lt
ok $? 'a click on the left arrow lowers the volume' "$values"
sleep 1
click_arrow raise -gt
ok $? 'a click on the right arrow raises the volume' "$values"
picture sound
xdotool mousemove 30 700
point_to back && tap F2 test && becomes on_top 1

go_to devices lines
ok $? 'SERVICE selects the page of lines, and TEST opens it' "$values"
tap 5 coins && becomes test_coins 1
ok $? 'a coin on the page of lines is a test of the slot' "$values"
[ "$(value_of fallen)" -eq 0 ] && [ "$(value_of credits)" -eq 0 ] && [ "$(value_of metered)" -eq 1 ]
ok $? 'a test coin is metered and gives no credit' "$values"
picture lines
tap F2 test && becomes on_devices 1
ok $? 'TEST returns to the page of devices' "$values"
tap 5 coins && becomes metered 2 && [ "$(value_of fallen)" -eq 0 ] && [ "$(value_of credits)" -eq 0 ]
ok $? 'a coin on another menu page is a test as well' "$values"

point_to back && tap F2 test && becomes on_top 1 && go_to upkeep files
ok $? 'SERVICE selects the page of files, and TEST opens it' "$values"
[ "$(value_of files)" -eq 2 ]
ok $? 'the page of files lists the database and the rejected species' "$values"
shows "$green" $store && shows "$red" $refused
ok $? 'the database is shown as in use, and the species as rejected'
picture files
point_to back && tap F2 test && becomes on_upkeep 1
ok $? 'BACK returns to the upkeep page' "$values"
point_to back && tap F2 test && becomes on_top 1 && point_to back && tap F2 test && becomes phase $attract
ok $? 'the last tag of the menu returns to attract mode' "$values"
shows "$water" $tank
ok $? 'the tank is bright again'

# ---- Coins --------------------------------------------------------------------------------------
tap 5 coins && becomes fallen 1 && [ "$(value_of credits)" -eq 0 ]
ok $? 'the first of two coins gives no full credit' "$values"
tap space start && sleep 2 && becomes phase $attract && [ "$(value_of taken)" -eq 0 ]
ok $? 'START without a credit begins no round' "$values"
shows "!($green)" $plate && shows "!($red)" $start
ok $? 'the credit plate is not lit'
tap 5 coins && becomes credits 1 && [ "$(value_of fallen)" -eq 0 ]
ok $? 'the second coin completes the credit' "$values"
[ "$(value_of metered)" -eq 4 ]
ok $? 'both coins are metered, like the test coins' "$values"
shows "$green" $plate && shows "$red" $start
ok $? 'the credit plate is lit, and the ribbon asks for START'
picture paid
tap space start && becomes taken 1 && becomes credits 0
ok $? 'START begins a round and takes the credit' "$values"
becomes phase $round
ok $? 'the round runs' "$values"

# ---- Ending a round by two presses of TEST ---------------------------------------------------------
# The question is shown for five seconds. The press is repeated if the machine shows no picture in
# that time.
unconfirmed=1
for _ in 1 2 3; do
    seen=$(value_of test)
    xdotool key F2
    for _ in $(seq 60); do
        region_is "$red" $question && unconfirmed=0 && break
        [ "$(value_of test)" -gt "$seen" ] && [ "$(value_of asks)" -eq 0 ] && break
    done
    becomes test $((seen + 1))
    [ $unconfirmed -eq 0 ] && break
done
ok $unconfirmed 'F2 in a round asks a question over the tank' "$values"
picture asks
becomes asks 0 && [ "$(value_of phase)" -eq $round ] && [ "$(value_of given_back)" -eq 0 ]
ok $? 'one press of F2 does not end the round' "$values"
shows "!($red)" $question
ok $? 'the question disappears'
for _ in 1 2 3 4; do
    # Two presses in one frame count as one press, so the loop presses again.
    xdotool key F2 sleep 1 key F2
    becomes phase $menu 10 >/dev/null && break
done
becomes phase $menu && becomes given_back 1 && becomes credits 1
ok $? 'a second press of F2 ends the round, opens the menu and returns the credit' "$values"

# ---- The end ------------------------------------------------------------------------------------
xdotool key Escape
becomes phase $attract
ok $? 'Escape in the menu returns to attract mode' "$values"
xdotool key Escape
sleep 1
import -window root "$BUILD/results/quit.png" 2>/dev/null
kill -0 "$kiosk_pid"
ok $? 'the first Escape in attract mode asks a question'
quit_by_key
end_of_kiosk 30
ok "$code" 'the second Escape ends the kiosk with code 0' "$work/err"
grep -q 'species/bad.kfish: magic' "$work/err" && one_line "$work/err"
ok $? 'standard error has only the message on the rejected species' "$work/err"
[ "$(value_of differs_at)" -eq 0 ] && [ ! -s "$work/state_writer.log" ]
ok $? "every tick of the kiosk equals the tick that tests/vm/state_writer computed" "$values"
"$BUILD/kingyoctl" replay verify "$recording" >"$work/verify" 2>&1
ok $? 'the recording with menu and coins verifies' "$work/verify"
done_testing
