#!/bin/bash
# kiosk_trials.sh -- runs real kiosks with failing file calls, and checks the data after a power
# cut.
#   kiosk_trials.sh TRIALS [SEED]
# Each trial runs two kiosks one after the other in a window of a virtual screen, under
# tests/power/preload.c. Coins are inserted, calls fail by seed, and SIGKILL ends the kiosk. The
# second kiosk continues with the same files and ends in the same way. tests/power/kiosk_check.c
# then cuts the power at several places of both. JOBS trials run in parallel. At the end one kiosk
# has every sync fail: its status must report this, and kingyoctl must exit with 1. Exits with 1 if
# an entry was lost or duplicated, if a database could not be opened, or if fewer calls than TRIALS
# failed, because the faults were then not injected.
# shellcheck disable=SC2154,SC1091  # The sourced file sets `work`.
set -u
trials=$1 first_seed=${2:-1}
BUILD=${BUILD:-build}
jobs=${JOBS:-$(nproc)}
. tests/e2e/lib.sh
here=$PWD
case $BUILD in /*) ;; *) BUILD=$here/$BUILD ;; esac

# Runs one kiosk under the library until its end. The exit status 137 means SIGKILL.
run_kiosk() { # FOLDER SEED [VARIABLES...]
    local folder=$1 seed=$2
    shift 2
    mkdir -p "$folder/data" "$folder/run"
    timeout -s KILL 120 env "$@" KINGYO_FAULT_DIR="$folder/data" KINGYO_FAULT_TAPE="$folder/tape" \
        KINGYO_FAULT_SEED="$seed" RUNTIME_DIRECTORY="$folder/run" LD_PRELOAD="$BUILD/tests/power/preload.so" \
        "$BUILD/kingyo" --window 320x240 --lang en --coins 1 --poi bot --keyboard on \
        --data "$folder/data" >"$folder/out" 2>&1
}

run_trial() { # NUMBER: Runs one trial of two kiosks and checks its data.
    local folder=$work/trial-$1
    run_kiosk "$folder" $((2 * $1 + 1000 * first_seed))
    run_kiosk "$folder" $((2 * $1 + 1 + 1000 * first_seed))
    "$BUILD/tests/power/kiosk_check" "$folder/tape" "$folder/cut" "$1" >"$folder/verdict" 2>"$folder/why"
    rm -rf "$folder/tape" "$folder/data" "$folder/cut"
}

open_screen
for ((trial = 0; trial < trials; trial++)); do
    while [ "$(jobs -rp | wc -l)" -ge "$jobs" ]; do wait -n; done
    run_trial $trial 2>/dev/null & # Hides the message that Bash prints for each SIGKILL.
done
while [ "$(jobs -rp | wc -l)" -gt 0 ]; do wait -n; done

cat "$work"/trial-*/why | head -5 >&2
cat "$work"/trial-*/verdict | awk -v trials="$trials" '
    { checked++; cuts += $1; acked += $2; found += $3; lost += $4; doubled += $5; unopenable += $6; coins += $7; unwell += $8
      for (i = 0; i < 6; i++) { failed[i] += $(9 + i); calls += $(9 + i) } }
    END {
        printf "  %d real kiosks, killed twice each: %d coins dropped, %d entries acknowledged, %d found at the end\n", checked, coins, acked, found
        printf "  calls that failed: %d fsync, %d fdatasync, %d write, %d pwrite, %d ftruncate, %d rename; %d statuses reported a failing store\n", \
            failed[0], failed[1], failed[2], failed[3], failed[4], failed[5], unwell
        printf "  %d cuts: %d lost, %d doubled, %d unopenable\n", cuts, lost, doubled, unopenable
        if (calls < trials) printf "  too few failed calls: %d, expected at least %d\n", calls, trials
        exit !(checked == trials && acked > 0 && calls >= trials && lost + doubled + unopenable == 0)
    }'
verdict=$?

# If every sync fails from the beginning, no entry is ever acknowledged.
never=$work/never
{ run_kiosk "$never" 7 KINGYO_FAULT_SYNCS=1; } 2>/dev/null
"$BUILD/kingyoctl" status --file "$never/run/status.json" >"$never/status"
code=$?
saved=$(sed -n 's/.*"saved_id": \([0-9]*\).*/\1/p' "$never/run/status.json")
echo "  with every sync failing: $saved entries acknowledged, kingyoctl status exits $code"
[ "$saved" = 0 ] && [ "$code" = 1 ] || { cat "$never/status" >&2; verdict=1; }
exit $verdict
