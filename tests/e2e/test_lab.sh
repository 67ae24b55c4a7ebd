#!/bin/bash
# test_lab.sh -- the real kiosk, a real pointer: somebody drags a knot of the growth lab, saves the
# graph, and finds it there at the next start.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/lib.sh"
recording=$work/lab.kgr
graph=$work/data/graphs/wakin.graph

# On a window of 1280x720 the canvas of core/game/lab/lab_layout.h is the window. A press is a dip of the
# poi: it takes about 0.15 s down and as long up.
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
wait_for_file() { # FILE: up to 10 s
    for _ in $(seq 50); do
        [ -s "$1" ] && return 0
        sleep 0.2
    done
    return 1
}

open_screen
start_kiosk --seed 5 --mode lab --record "$recording"
ok $? 'the kiosk opens the lab' "$work/err" || { done_testing; exit 1; }
press_at 124 675 # Play is on from the start: stop.
press_at 1019 466 # Two at a time: knots stand at the keys.
[ ! -e "$graph" ]
ok $? 'nothing is kept that nobody saved'
# The second key's knot at 100 % of five: a quarter of the plot, its top. Down by a third.
drag 936 128 936 202
press_at 899 675
wait_for_file "$graph"
ok $? 'SAVE writes a text into the data folder' "$work/err"
import -window root "$BUILD/results/lab.png" 2>/dev/null
grep -qx 'template pairwise' "$graph" && awk '$1 == "knot" && $2 > 0.2 && $2 < 0.3 && $4 > 0.55 && $4 < 0.8 { found = 1 }
    $1 == "knot" { sum = 0; for (i = 3; i <= NF; i++) sum += $i; if (sum < 0.999999 || sum > 1.000001) bad = 1 }
    END { exit !(found && !bad) }' "$graph"
ok $? 'and in it the knot is where it was dragged, its weights summing to 1' "$graph"
cp "$graph" "$work/first.graph"
quit_by_key
end_of_kiosk 20
ok "$code" 'Escape twice ends the kiosk with code 0' "$work/err"
"$BUILD/kingyoctl" replay verify "$recording" >"$work/verify" 2>&1
ok $? 'the recording goes through the lab again, to the last bit' "$work/verify"

start_kiosk --seed 5 --mode lab --record "$work/second.kgr"
ok $? 'the kiosk opens again' "$work/err"
press_at 899 675 # Save is idle: what is kept is what is shown.
quit_by_key
end_of_kiosk 20
cmp -s "$graph" "$work/first.graph"
ok $? 'and what was kept is on the table, unchanged' "$graph"
"$BUILD/kingyoctl" replay verify "$work/second.kgr" >"$work/verify" 2>&1
ok $? 'a recording that began with a kept graph verifies elsewhere' "$work/verify"

# A maker's fish: the wakin's text under a name of its own, packed; beside it a file that is none.
mkdir -p "$work/data/species"
sed 's/^species wakin$/species funa/' assets/species/wakin.txt >"$work/funa.txt"
"$BUILD/kingyoctl" morph import "$work/data/species/funa.kfish" "$work/funa.txt" >"$work/verify" 2>&1
ok $? "a maker's text becomes a packed species" "$work/verify"
echo nonsense >"$work/data/species/bad.kfish"
start_kiosk --seed 5 --mode lab --record "$work/third.kgr"
ok $? 'the kiosk opens with it' "$work/err"
press_at 61 40 # Back from the first is the last: the maker's.
press_at 1019 466
press_at 899 675
wait_for_file "$work/data/graphs/funa.graph"
ok $? "it is on the lab's table: a graph of it is kept" "$work/err"
sleep 2
import -window root "$BUILD/results/lab_maker.png" 2>/dev/null
quit_by_key
end_of_kiosk 20
grep -q 'funa.kfish: funa' "$work/out" && grep -q 'species/bad.kfish: magic' "$work/err" && one_line "$work/err"
ok $? 'the log names the good one, and the bad one with its reason' "$work/err"
"$BUILD/kingyoctl" replay verify "$work/third.kgr" >"$work/verify" 2>&1
ok $? "the recording of a maker's fish verifies elsewhere" "$work/verify"
rm -r "$work/data/species" "$work/data/graphs/funa.graph"

echo 'kingyo-graph 1' >"$graph"
start_kiosk --seed 5 --mode lab
ok $? 'a damaged graph keeps no stall closed' "$work/err"
quit_by_key
end_of_kiosk 20
grep -q "graphs/wakin.graph:1: " "$work/err" && one_line "$work/err"
ok $? 'it costs one line that names the file' "$work/err"
done_testing
