#!/bin/bash
# test_poi_program.sh -- kingyo-poi: scripts, simulation, self-test, calibration and exit codes. A
# folder simulates the board. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
poi=$build/kingyo-poi

ends() { # CODE PATTERN ARGUMENTS...: Standard input is that of the caller.
    local code=$1 pattern=$2 status
    shift 2
    "$poi" "$@" >"$work/out" 2>"$work/err"
    status=$?
    echo "exit code $status, expected $code"
    cat "$work/err"
    [ $status -eq "$code" ] && cat "$work/out" "$work/err" | grep -q -- "$pattern"
}

printf 'adc = none\nwire1 = 250 0.25\nwire2 = 250 0.25\nwire3 = 250 0.25\n' >"$work/calibrated.conf"

# ---- Wrong arguments ------------------------------------------------------------------------------
check 'a missing command is wrong usage' ends 2 'COMMAND'
check 'an unknown command is wrong usage' ends 2 'unknown command' fly
check 'an unknown option is wrong usage' ends 2 'unknown option' run --fast
check 'a rate of 5000 is wrong usage' ends 2 'expected a whole number from 50 to 1000' run --simulate --rate 5000
check 'a missing value is wrong usage' ends 2 'needs a value' run --simulate --rate
check 'an empty --root means this machine' ends 74 'in /sys/bus/iio' run --root '' --device - \
    --config "$work/calibrated.conf"
check 'two sources are wrong usage' ends 2 'exclude' run --simulate --script
check 'a missing device exits with 74' ends 74 'kingyo-poi-gadget start' run --simulate --device "$work/none"
check 'a missing configuration exits with 74' ends 74 'No such file' run --config "$work/none"
check '--help exits with 0' ends 0 'calibrate' --help
printf 'adc = mcp3208\nspool1 = 0 1\n' >"$work/bad.conf"
check 'a wrong line of the configuration is reported' ends 65 'bad.conf:2: a spool is' test --config "$work/bad.conf"
check 'run without calibration exits with 1' ends 1 'kingyo-poi calibrate' run \
    --config board/poi-gadget/poi.conf --device -

# ---- Scripts --------------------------------------------------------------------------------------
bytes() { # Prints the reports of standard input as one line each.
    od -An -v -w15 -tx1 | tr -d ' '
}
plays() {
    # Each pose is held for some time, because a busy machine skips lines when it misses cycles.
    printf '%s\n' '0 0 0 0 0 0' '+200 0 0 0 0 0 0' '100 -50 0 -45 0 0 OK' '+200 100 -50 0 -45 0 0 OK' \
        'lost START' '+200 lost START' | "$poi" run --script --device - 2>/dev/null | bytes >"$work/played"
    # X alternates by one step. Y of -50 mm is -1638, and a pitch of -45 degrees is -8192. A lost
    # position is 8000 in hexadecimal.
    sed -E 's/^01..(0000|0100|ffff)0{22}$/A/; s/^01..(cc|cd)0c9af9000000e00000000001$/B/
        s/^01..0080000000000*02$/C/' "$work/played" | uniq | tr -d '\n' >"$work/order"
    head -3 "$work/played"
    cat "$work/order"
    [[ $(cat "$work/order") =~ ^A(01..(cc|cd)0c9af9000000e00000000003)?B(01..0080000000000*03)?C$ ]]
}
check 'the lines of a script become poses in their order' plays
glides() {
    printf '%s\n' '0 0 0 0 0 0' '+100 100 0 0 0 0 0' | "$poi" run --script --rate 100 --device - 2>/dev/null | bytes >"$work/glided"
    cat "$work/glided" # Fewer where this machine is too busy to beat so fast; the way is the same.
    [ "$(wc -l <"$work/glided")" -le 11 ] && [ "$(wc -l <"$work/glided")" -gt 1 ] && [[ $(tail -1 "$work/glided" | cut -c5-8) =~ ^(cc|cd)0c$ ]]
}
check 'a glide of 100 ms gives at most ten reports and then ends' glides
never_still() { # The kiosk treats a sensor that repeats a value bit for bit as frozen.
    yes '10 20 30 0 0 0' | head -50 | "$poi" run --script --rate 1000 --device - 2>/dev/null | bytes |
        cut -c5- | uniq -c | awk '$1 > 1 { exit 1 }'
}
check 'the poses of a script are never identical bit for bit' never_still
bad_line() { printf '0 0 0 0 0 0\n0 0 0 0 0 up\n' | ends 65 'standard input:2: an angle' run --script --device -; }
check 'an invalid line is reported with its number' bad_line
# If a pipe stays open, the poi keeps its pose and continues with the next line.
waits() {
    mkfifo "$work/pipe"
    "$poi" run --script --rate 100 --device - <"$work/pipe" >"$work/waited" 2>/dev/null &
    local first last tries=0
    exec 7>"$work/pipe"
    echo '10 0 0 0 0 0' >&7
    while [ "$(stat -c %s "$work/waited")" -lt 300 ] && [ $tries -lt 200 ]; do
        tries=$((tries + 1))
        sleep 0.05
    done
    echo '20 0 0 0 0 0' >&7
    exec 7>&-
    wait
    first=$(bytes <"$work/waited" | grep -cE '^01..4[78]01')
    last=$(bytes <"$work/waited" | tail -1 | cut -c5-8)
    echo "$first reports at 10 mm, then $last"
    [ "$first" -ge 20 ] && [[ $last =~ ^(8f|90)02$ ]]
}
check 'an open pipe keeps the last pose' waits
takes() { # The output of watch is a script that gives the same poses.
    "$poi" watch --simulate --rate 100 --seconds 1 >"$work/take" &&
        "$poi" watch --script --rate 100 <"$work/take" >"$work/again" &&
        [ "$(wc -l <"$work/take")" -ge 20 ] &&
        awk 'NR == FNR { take[++count] = $0; next }
            { # The same poses in the same order, except for those of missed cycles.
                for (found = 0; !found && at < count;) {
                    split(take[++at], was)
                    found = 1
                    for (i = 1; i <= 6; i++) if (($i - was[i]) ^ 2 > 0.04 ^ 2) found = 0
                }
                if (!found) exit 1
                seen++
            }
            END { exit seen < 20 }' "$work/take" "$work/again"
}
check 'a recorded take can be played again' takes

# ---- Simulation -----------------------------------------------------------------------------------
# In ten seconds the poi dips, rises, tips over the bowl at 335, 185 mm and dips at another place.
scoops() {
    "$poi" watch --simulate --rate 50 --seconds 10 >"$work/scoops"
    awk '$2 < -40 { if (!down) dips++; down = 1; if (dips == 1) first = $1; else second = $1 }
         $2 > 20 { down = 0 }
         $6 > 50 && $1 > 255 && $1 < 415 && $3 > 105 { tips++ }
         END { print dips " dips, " tips " reports of tipping, at " first " and " second
               exit !(dips == 2 && tips > 2 && (first - second) ^ 2 > 900) }' "$work/scoops"
}
check 'the simulation scoops at different places' scoops
beats() {
    "$poi" run --simulate --rate 500 --seconds 2 --device - 2>"$work/err" | wc -c >"$work/bytes"
    cat "$work/err"
    # The late cycles of a busy machine are reported, and no report is lost among 1000 cycles.
    awk -v late="$(sed -E 's/.* ([0-9]+) of [0-9]+ cycles late.*/\1/' "$work/err")" \
        -v beats="$(sed -E 's/.* of ([0-9]+) cycles late.*/\1/' "$work/err")" '{ reports = $1 / 15
            exit !($1 % 15 == 0 && beats >= 999 && (reports + late - beats) ^ 2 <= 4) }' "$work/bytes"
}
check '500 cycles a second give 500 reports, or the late cycles are reported' beats

# ---- A simulated board ----------------------------------------------------------------------------
iio=$work/board/sys/bus/iio/devices
mkdir -p "$iio/iio:device0" "$iio/iio:device1"
echo mcp3208 >"$iio/iio:device0/name"
echo bno055 >"$iio/iio:device1/name"
echo '11585 11585 0 0' >"$iio/iio:device1/in_rot_quaternion_raw"
: >"$work/hidg0"

# Writes the values of the three converters for X Y Z in mm. Each step of a converter
# is 0.25 mm of wire, from 200.
hold_at() {
    awk -v x="$1" -v y="$2" -v z="$3" -v folder="$iio/iio:device0" 'BEGIN {
        split("-450 450 0", sx); split("-300 -300 350", sz)
        for (i = 1; i <= 3; i++) {
            length_mm = sqrt((x - sx[i]) ^ 2 + (y - 750) ^ 2 + (z - sz[i]) ^ 2)
            printf "%.0f\n", (length_mm - 200) / 0.25 >(folder "/in_voltage" (i - 1) "_raw")
        } }'
}
prompted() { # PATTERN TIMES: Waits up to 10 s until calibrate has asked TIMES times.
    local tries=0
    until [ "$(grep -c "$1" "$work/prompts")" -ge "$2" ]; do
        tries=$((tries + 1))
        [ $tries -lt 200 ] || { cat "$work/prompts"; return 1; }
        sleep 0.05
    done
}
calibrates() {
    mkfifo "$work/hand"
    hold_at 0 0 0
    "$poi" calibrate --config board/poi-gadget/poi.conf --root "$work/board" <"$work/hand" \
        >"$work/lines" 2>"$work/prompts" &
    local pid=$! mark=0
    exec 8>"$work/hand"
    while read -r x y z; do
        mark=$((mark + 1))
        prompted '^mark' $mark || return 1
        hold_at "$x" "$y" "$z"
        echo >&8
    done <<<"-300 0 -200
300 0 -200
0 0 200
0 200 0"
    prompted 'lay the poi' 1 || return 1
    echo >&8
    exec 8>&-
    wait $pid || { cat "$work/prompts"; return 1; }
    cat "$work/lines"
    awk '/^wire/ { n++; if (($3 - 200) ^ 2 > 0.3 || ($4 - 0.25) ^ 2 > 1e-6) exit 1 } END { exit n != 3 }' \
        "$work/lines"
}
check 'calibrate computes the length of a step of each wire' calibrates
cat board/poi-gadget/poi.conf "$work/lines" >"$work/poi.conf"
sees() { # The eye of the poi is at 0 100 0. The ring is 15 mm below and 60 mm in front of the eye.
    hold_at 0 100 0
    "$poi" watch --config "$work/poi.conf" --root "$work/board" --rate 50 --seconds 1 >"$work/seen" 2>/dev/null
    tail -1 "$work/seen"
    tail -1 "$work/seen" | awk '{ exit !($1 ^ 2 < 1 && ($2 - 85) ^ 2 < 1 && ($3 + 60) ^ 2 < 1) }'
}
check 'a calibrated poi computes its position' sees
check 'a complete board passes its self-test' ends 0 '^10 ok, 0 failed' test --config "$work/poi.conf" \
    --root "$work/board" --device "$work/hidg0"
echo 1 >"$iio/iio:device0/in_voltage1_raw"
check 'a wire at its end stop fails the self-test' ends 1 'FAIL  wire 2' test --config "$work/poi.conf" \
    --root "$work/board" --device "$work/hidg0"
check 'a wire at its end stop gives no position' ends 1 'FAIL  place' test --config "$work/poi.conf" --root "$work/board" \
    --device "$work/hidg0"
hold_at 0 100 0
check 'a disconnected cable fails the self-test' ends 1 'FAIL  cable' test --config "$work/poi.conf" \
    --root "$work/board" --device "$work/none"
rm "$iio/iio:device1/name"
check 'a missing sensor fails the self-test' ends 1 "FAIL  sensors    no inertial sensor 'bno055'" test --config "$work/poi.conf" \
    --root "$work/board" --device "$work/hidg0"
check 'run with a missing sensor exits with 74' ends 74 'checks all parts' run --config "$work/poi.conf" \
    --root "$work/board" --device -
echo "1..$count"
