#!/bin/bash
# test_faults.sh -- wrong words, bad paths, a screen that goes away: one line, a defined exit code, no
# crash, and what was being recorded stays valid.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/lib.sh"

# Runs PROGRAM WORDS..., expects CODE, one line on standard error and TEXT in it.
refuses() { # CODE TEXT TITLE PROGRAM WORDS...
    local expected=$1 text=$2 title=$3 got
    shift 3
    timeout 60 "$BUILD/$1" "${@:2}" >"$work/said" 2>"$work/err" </dev/null
    got=$?
    echo "exit $got, expected $expected" >>"$work/said"
    cat "$work/err" >>"$work/said"
    [ $got -eq "$expected" ] && one_line "$work/err" && grep -q -- "$text" "$work/err"
    ok $? "$title: one line and code $expected" "$work/said"
}

refuses 2 nonesuch 'an unknown option' kingyo --nonesuch
refuses 2 window 'a window of no size' kingyo --window 12
refuses 2 seed 'a seed that is no number' kingyo --seed tuna
refuses 2 record 'an option without its value' kingyo --record
refuses 2 lang 'a language that we do not speak' kingyo --lang fr
refuses 2 mode 'a mode that nobody plays' kingyo --mode tournament
refuses 2 grade 'paper that no mill sells' kingyo --grade 9
refuses 2 players 'more players than find room' kingyo --players 5
refuses 2 word 'a word that is no option' kingyo word
refuses 74 /nowhere/x.kgr 'a replay that is not there' kingyo --replay /nowhere/x.kgr
refuses 74 /proc/x.kgr 'a recording that cannot be written' kingyo --demo 5 --record /proc/x.kgr --shots "$work"
refuses 74 /proc/x 'a folder for pictures that cannot be made' kingyo --demo 5 --shots /proc/x
refuses 74 /nowhere/x.conf 'a configuration that is not there' kingyo --config /nowhere/x.conf
refuses 2 tickle 'a command that kingyoctl has not' kingyoctl tickle
refuses 74 /nowhere/x.kgr 'verifying what is not there' kingyoctl replay verify /nowhere/x.kgr
refuses 74 folder 'verifying a folder' kingyoctl replay verify "$work"

# A good recording, then the ways to spoil it.
good=$work/good.kgr
"$BUILD/kingyo" --demo 5 --seed 7 --shots "$work/shots" --record "$good" >"$work/said" 2>&1 </dev/null
ok $? 'a demonstration without a screen writes a recording' "$work/said"
"$BUILD/kingyoctl" replay verify "$good" >"$work/said" 2>&1
ok $? 'which verifies' "$work/said"
"$BUILD/kingyo" --replay "$good" --window 320x240 --shots "$work/shown" >"$work/said" 2>&1 </dev/null
ok $? 'without a screen the replay is shown in pictures' "$work/said"
grep -q '^No screen: .* The replay is checked, and pictures of it are written\.$' "$work/said" &&
    ! grep -q 'bot' "$work/said" && grep -q ' each as recorded$' "$work/said" && [ -s "$work/shown/contact-sheet.png" ]
ok $? 'it says so, and checks every tick' "$work/said"
size=$(stat -c %s "$good")
head -c $((size / 2)) "$good" >"$work/short.kgr"
refuses 65 short.kgr 'a recording cut in half' kingyoctl replay verify "$work/short.kgr"
cp "$good" "$work/altered.kgr"
printf '\377\377' | dd of="$work/altered.kgr" bs=1 seek=$((size * 2 / 3)) conv=notrunc 2>/dev/null
refuses 65 altered.kgr 'a recording with two bytes changed' kingyoctl replay verify "$work/altered.kgr"
head -c 5000 /dev/urandom >"$work/noise.kgr"
refuses 65 noise.kgr 'a file of noise' kingyoctl replay verify "$work/noise.kgr"
: >"$work/empty.kgr"
refuses 65 empty.kgr 'an empty file' kingyo --replay "$work/empty.kgr" --demo 5 --shots "$work"

verifies() { # FILE TITLE
    "$BUILD/kingyoctl" replay verify "$1" >"$work/said" 2>&1
    ok $? "$2" "$work/said"
}

ended() { # STATUS TITLE, after end_of_kiosk
    echo "exit $code" >>"$work/err"
    ok "$1" "$2" "$work/err"
}

# The screen vanishes in mid-round: somebody pulled the plug of the whole X server.
open_screen
start_kiosk --seed 8 --record "$work/vanish.kgr"
ok $? 'the kiosk plays on a screen' "$work/err"
xdotool key space
sleep 3
close_screen
end_of_kiosk 20
[ "$code" -eq 1 ] && one_line "$work/err"
ended $? 'a display that vanishes ends it with one line and code 1'
verifies "$work/vanish.kgr" 'and what was recorded until then verifies'

# The window is destroyed by somebody else, which is not the same as being closed.
open_screen
start_kiosk --seed 9 --record "$work/lost.kgr"
ok $? 'the kiosk plays again' "$work/err"
sleep 1
xdotool windowkill "$window"
end_of_kiosk 20
[ "$code" -eq 1 ] && one_line "$work/err"
ended $? 'a killed window ends it with one line and code 1'
verifies "$work/lost.kgr" 'and what was recorded until then verifies'

# Closed by its user.
start_kiosk --seed 10 --record "$work/closed.kgr"
ok $? 'and once more, on the same screen' "$work/err"
sleep 1
"$BUILD/tests/e2e/ask_to_close" "$window"
end_of_kiosk 20
[ "$code" -eq 0 ] && [ ! -s "$work/err" ]
ok $? 'a window that its user closes ends it in peace with code 0' "$work/err"
verifies "$work/closed.kgr" 'and the recording verifies'

# Its data folder cannot be had: a service that ended for that would be a dead stall.
start_kiosk --data /proc/x
ok $? 'the stall opens without a data folder' "$work/err"
kill -TERM "$kiosk_pid"
end_of_kiosk 20
[ "$code" -eq 0 ] && grep -q 'store  *no store: /proc/x' "$work/out"
ok $? 'and says so' "$work/out"

# Ended by the system.
start_kiosk --seed 11 --record "$work/ended.kgr"
sleep 1
kill -TERM "$kiosk_pid"
end_of_kiosk 20
[ "$code" -eq 0 ] && [ ! -s "$work/err" ]
ok $? 'SIGTERM ends it in peace with code 0' "$work/err"
verifies "$work/ended.kgr" 'and the recording verifies'

# Ended by force: nothing could be said, but what is on disk is whole to the last written second.
start_kiosk --seed 12 --record "$work/killed.kgr"
sleep 3
kill -KILL "$kiosk_pid"
end_of_kiosk 20
verifies "$work/killed.kgr" 'a recording of a kiosk that was killed verifies'
done_testing
