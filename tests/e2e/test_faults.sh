#!/bin/bash
# test_faults.sh -- wrong options, bad paths and a display that disappears: one line, a defined
# exit code, no crash, and a valid recording.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"

# Runs PROGRAM WORDS... and expects exit code CODE and one line on standard error that contains
# TEXT.
refuses() { # CODE TEXT TITLE PROGRAM WORDS...
    local expected=$1 text=$2 title=$3 got
    shift 3
    timeout 60 "$BUILD/$1" "${@:2}" >"$work/output" 2>"$work/err" </dev/null
    got=$?
    echo "exit $got, expected $expected" >>"$work/output"
    cat "$work/err" >>"$work/output"
    [ $got -eq "$expected" ] && one_line "$work/err" && grep -q -- "$text" "$work/err"
    ok $? "$title: one line and code $expected" "$work/output"
}

refuses 2 nonesuch 'an unknown option' kingyo --nonesuch
refuses 2 window 'a window of no size' kingyo --window 12
refuses 2 seed 'a seed that is not a number' kingyo --seed tuna
refuses 2 record 'an option without its value' kingyo --record
refuses 2 lang 'an unknown language' kingyo --lang fr
refuses 2 mode 'an unknown mode' kingyo --mode tournament
refuses 2 grade 'an unknown paper grade' kingyo --grade 9
refuses 2 players 'too many players' kingyo --players 5
refuses 2 word 'a surplus argument' kingyo word
refuses 74 /nowhere/x.kgr 'a missing replay' kingyo --replay /nowhere/x.kgr
refuses 74 /proc/x.kgr 'a recording that cannot be written' kingyo --demo 5 --record /proc/x.kgr --shots "$work"
refuses 74 /proc/x 'a picture folder that cannot be created' kingyo --demo 5 --shots /proc/x
refuses 74 /nowhere/x.conf 'a missing configuration' kingyo --config /nowhere/x.conf
SDL_VIDEODRIVER=dummy refuses 1 'the self-test needs a screen' 'a self-test without a screen' kingyo --selftest-board 5
refuses 2 tickle 'an unknown command of kingyoctl' kingyoctl tickle
refuses 74 /nowhere/x.kgr 'replay verify of a missing file' kingyoctl replay verify /nowhere/x.kgr
refuses 74 folder 'replay verify of a folder' kingyoctl replay verify "$work"

# A valid recording, then damaged copies of it.
good=$work/good.kgr
"$BUILD/kingyo" --demo 5 --seed 7 --shots "$work/shots" --record "$good" >"$work/output" 2>&1 </dev/null
ok $? 'a demonstration without a screen writes a recording' "$work/output"
"$BUILD/kingyoctl" replay verify "$good" >"$work/output" 2>&1
ok $? 'the recording of the demonstration verifies' "$work/output"
"$BUILD/kingyo" --replay "$good" --window 320x240 --shots "$work/shown" >"$work/output" 2>&1 </dev/null
ok $? 'a replay without a screen writes pictures' "$work/output"
grep -q '^No screen: .* The replay is checked, and pictures of it are written\.$' "$work/output" &&
    ! grep -q 'bot' "$work/output" && grep -q ' each as recorded$' "$work/output" && [ -s "$work/shown/contact-sheet.png" ]
ok $? 'a replay without a screen reports the missing screen and checks every tick' "$work/output"
size=$(stat -c %s "$good")
head -c $((size / 2)) "$good" >"$work/short.kgr"
refuses 65 short.kgr 'a recording cut in half' kingyoctl replay verify "$work/short.kgr"
cp "$good" "$work/altered.kgr"
printf '\377\377' | dd of="$work/altered.kgr" bs=1 seek=$((size * 2 / 3)) conv=notrunc 2>/dev/null
refuses 65 altered.kgr 'a recording with two bytes changed' kingyoctl replay verify "$work/altered.kgr"
head -c 5000 /dev/urandom >"$work/noise.kgr"
refuses 65 noise.kgr 'a file of random bytes' kingyoctl replay verify "$work/noise.kgr"
: >"$work/empty.kgr"
refuses 65 empty.kgr 'an empty file' kingyo --replay "$work/empty.kgr" --demo 5 --shots "$work"

verifies() { # FILE TITLE: Test TITLE: the recording FILE is valid.
    "$BUILD/kingyoctl" replay verify "$1" >"$work/output" 2>&1
    ok $? "$2" "$work/output"
}

ended() { # STATUS TITLE, after end_of_kiosk
    echo "exit $code" >>"$work/err"
    ok "$1" "$2" "$work/err"
}

# The display disappears during a round, because the X server is killed.
open_screen
start_kiosk --seed 8 --record "$work/vanish.kgr"
ok $? 'the kiosk starts on a screen' "$work/err"
xdotool key space
sleep 3
close_screen
end_of_kiosk 20
[ "$code" -eq 1 ] && one_line "$work/err"
ended $? 'a display that disappears ends the kiosk with one line and code 1'
verifies "$work/vanish.kgr" 'the recording until the display disappeared verifies'

# Another program destroys the window, which differs from closing it.
open_screen
start_kiosk --seed 9 --record "$work/lost.kgr"
ok $? 'the kiosk starts on a second screen' "$work/err"
sleep 1
xdotool windowkill "$window"
end_of_kiosk 20
[ "$code" -eq 1 ] && one_line "$work/err"
ended $? 'a destroyed window ends the kiosk with one line and code 1'
verifies "$work/lost.kgr" 'the recording until the window was destroyed verifies'

# The user closes the window.
start_kiosk --seed 10 --record "$work/closed.kgr"
ok $? 'the kiosk starts again on the same screen' "$work/err"
sleep 1
"$BUILD/tests/e2e/ask_to_close" "$window"
end_of_kiosk 20
[ "$code" -eq 0 ] && [ ! -s "$work/err" ]
ok $? 'a closed window ends the kiosk with code 0 and without a message' "$work/err"
verifies "$work/closed.kgr" 'the recording of the closed window verifies'

# The data folder cannot be created. The kiosk must still open, because a service that ends in this
# case would stop the whole kiosk.
start_kiosk --data /proc/x
ok $? 'the kiosk opens without a data folder' "$work/err"
kill -TERM "$kiosk_pid"
end_of_kiosk 20
[ "$code" -eq 0 ] && grep -q 'store  *no store: /proc/x' "$work/out"
ok $? 'the kiosk reports the missing data folder' "$work/out"

# The system ends the kiosk.
start_kiosk --seed 11 --record "$work/ended.kgr"
sleep 1
kill -TERM "$kiosk_pid"
end_of_kiosk 20
[ "$code" -eq 0 ] && [ ! -s "$work/err" ]
ok $? 'SIGTERM ends the kiosk with code 0 and without a message' "$work/err"
verifies "$work/ended.kgr" 'the recording until SIGTERM verifies'

# SIGKILL ends the kiosk without a message, but the recording on disk is complete up to the last
# second that was written.
start_kiosk --seed 12 --record "$work/killed.kgr"
sleep 3
kill -KILL "$kiosk_pid"
end_of_kiosk 20
verifies "$work/killed.kgr" 'the recording until SIGKILL verifies'
done_testing
