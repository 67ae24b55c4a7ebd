#!/bin/bash
# test_lab.sh -- the real kiosk with a real pointer: a user drags a knot in the growth lab and
# saves the graph. The next start shows the saved graph.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"
recording=$work/lab.kgr
graph=$work/data/graphs/wakin.graph

# In a window of 1280x720 the canvas of core/game/lab/lab_layout.h equals the window. A press is a
# dip of the poi. Each stroke of a dip takes about half a second.
press_at() { # X Y
    xdotool mousemove "$1" "$2"
    sleep 0.3
    xdotool mousedown 1
    sleep 0.6
    xdotool mouseup 1
    sleep 0.6
}
drag() { # X Y TO_X TO_Y
    xdotool mousemove "$1" "$2"
    sleep 0.3
    xdotool mousedown 1
    sleep 0.6
    for i in 1 2 3 4 5 6 7 8; do
        xdotool mousemove $(($1 + ($3 - $1) * i / 8)) $(($2 + ($4 - $2) * i / 8))
        sleep 0.1
    done
    sleep 0.3
    xdotool mouseup 1
    sleep 0.8
}
wait_for_file() { # FILE: Waits up to 10 s.
    for _ in $(seq 50); do
        [ -s "$1" ] && return 0
        sleep 0.2
    done
    return 1
}

open_screen
start_kiosk --seed 5 --mode lab --record "$recording"
ok $? 'the kiosk opens the lab' "$work/err" || { done_testing; exit 1; }
press_at 124 675 # Playback runs after the start, so the press stops it.
press_at 1019 466 # Selects the pairwise template, whose knots stand at the keys.
[ ! -e "$graph" ]
ok $? 'no graph is written before SAVE is pressed'
# The knot of the second key at 100 % is at a quarter of the plot's width, at its top. The drag
# moves the knot down by a third.
drag 936 128 936 202
press_at 899 675
wait_for_file "$graph"
ok $? 'SAVE writes a text file into the data folder' "$work/err"
import -window root "$BUILD/results/lab.png" 2>/dev/null
grep -qx 'template pairwise' "$graph" && awk '$1 == "knot" && $2 > 0.2 && $2 < 0.3 && $4 > 0.55 && $4 < 0.8 { found = 1 }
    $1 == "knot" { sum = 0; for (i = 3; i <= NF; i++) sum += $i; if (sum < 0.999999 || sum > 1.000001) bad = 1 }
    END { exit !(found && !bad) }' "$graph"
ok $? 'the file has the knot at its new place, with weights that sum to 1' "$graph"
cp "$graph" "$work/first.graph"
quit_by_key
end_of_kiosk 20
ok "$code" 'two presses of Escape end the kiosk with code 0' "$work/err"
"$BUILD/kingyoctl" replay verify "$recording" >"$work/verify" 2>&1
ok $? 'the recording of the lab verifies' "$work/verify"

start_kiosk --seed 5 --mode lab --record "$work/second.kgr"
ok $? 'the kiosk opens again' "$work/err"
press_at 899 675 # SAVE has no effect, because the displayed graph is already saved.
quit_by_key
end_of_kiosk 20
cmp -s "$graph" "$work/first.graph"
ok $? 'the next start leaves the saved graph unchanged' "$graph"
"$BUILD/kingyoctl" replay verify "$work/second.kgr" >"$work/verify" 2>&1
ok $? 'a recording that began with a saved graph verifies' "$work/verify"

# A user's own species: the text of the wakin under another name, packed. A second file in the
# folder is not a species.
mkdir -p "$work/data/species"
sed 's/^species wakin$/species funa/' assets/species/wakin.txt >"$work/funa.txt"
"$BUILD/kingyoctl" morph import "$work/data/species/funa.kfish" "$work/funa.txt" >"$work/verify" 2>&1
ok $? "a user's text becomes a packed species" "$work/verify"
echo nonsense >"$work/data/species/bad.kfish"
start_kiosk --seed 5 --mode lab --record "$work/third.kgr"
ok $? 'the kiosk opens with the packed species' "$work/err"
press_at 61 40 # The step before the first species selects the last species, which is the user's own.
press_at 1019 466
press_at 899 675
wait_for_file "$work/data/graphs/funa.graph"
ok $? "the lab saves a graph of the user's species" "$work/err"
sleep 2
import -window root "$BUILD/results/lab_maker.png" 2>/dev/null
quit_by_key
end_of_kiosk 20
grep -q 'funa.kfish: funa' "$work/out" && grep -q 'species/bad.kfish: magic' "$work/err" && one_line "$work/err"
ok $? 'the log reports the loaded species, and the rejected file with its reason' "$work/err"
"$BUILD/kingyoctl" replay verify "$work/third.kgr" >"$work/verify" 2>&1
ok $? "the recording of the user's species verifies" "$work/verify"
rm -r "$work/data/species" "$work/data/graphs/funa.graph"

echo 'kingyo-graph 1' >"$graph"
start_kiosk --seed 5 --mode lab
ok $? 'the kiosk opens with a damaged graph' "$work/err"
quit_by_key
end_of_kiosk 20
grep -q "graphs/wakin.graph:1: " "$work/err" && one_line "$work/err"
ok $? 'a damaged graph gives one line that names the file' "$work/err"
done_testing
