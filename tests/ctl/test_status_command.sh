#!/bin/bash
# test_status_command.sh -- kingyoctl status: prints the status file, and exits with 1 if the kiosk
# is not well. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
build=$(realpath "$build")
file=$work/status.json
writes() { # AGE_S WELL: Writes the status file as the kiosk does.
    local now
    now=$(awk -v age="$1" '{ printf "%.0f", ($1 - age) * 1000 }' /proc/uptime)
    cat >"$file" <<JSON
{ "version": "0.1.0", "pid": 7, "written_ms": $now, "up_s": 7384, "boot": 12, "phase": "attract", "players": 2,
  "credits": {"paid": 3, "service": 1, "units": 2, "untold": 0, "round_open": false},
  "tickets": {"owed": 5, "dispensed": 37},
  "store": {"well": $2, "entry_id": 120, "saved_id": 118, "waiting": 2},
  "frames": {"count": 443040, "median_ms": 16.7, "p99_ms": 17.1}, "ticks": {"count": 886080, "dropped": 4},
  "faults": {"poi": 2, "fan": 0, "display": 0, "sound": 1, "store": 0, "buttons": 0, "switches": 0, "buttons_missing": 0},
  "machine": {"data": "proven", "backup_min": 12, "free_mib": 345, "heat_margin_c": ${3:-21}, "watchdog": "fed",
    "clock_day": ${4:-9726}, "clock_minute": 1110, "clock_went_back": false},
  "files": {"refused": 1, "set_aside": 2, "replays_missed": 3},
  "devices": [{"part": "display", "text": "OpenGL ES 3.1 V3D, 1920x1080"}, {"part": "sound", "text": "none"}] }
JSON
}
status() { "$build/kingyoctl" status --file "$file" "$@" >"$work/out" 2>"$work/err"; }
ends() { # CODE PATTERN ARGUMENTS...: Exits with CODE, and the output or the error matches PATTERN.
    local code=$1 pattern=$2 got
    shift 2
    status "$@"
    got=$?
    cat "$work/out" "$work/err"
    [ $got -eq "$code" ] && grep -qE -- "$pattern" "$work/out" "$work/err"
}
writes 1 true
check 'a running kiosk is reported with its version and phase' ends 0 '^kingyo 0.1.0, start 12, open for 2 h 03 min: attract$'
check 'the credits are printed' ends 0 '^  credits   3 paid, 1 of service, 2 units towards the next$'
check 'the tickets are printed' ends 0 '^  tickets   5 owed, 37 dispensed$'
check 'the state of the ledger is printed' ends 0 '^  ledger    well; 120 entries, 2 not on disk yet$'
check 'the frame times are printed' ends 0 '^  frames    443040, median 16.7 ms, p99 17.1 ms; 4 ticks dropped$'
check 'the state of the machine is printed' ends 0 \
    '^  machine   data proven; backup 12 min old; 345 MiB free; heat 21 degrees below slowing down; watchdog fed$'
check 'rejected, renamed and missing files are counted' ends 0 \
    '^  files     1 refused; 2 databases set aside and not seen; 3 scores without their replay$'
check 'only faults that occurred are printed' ends 0 '^  faults    poi 2, sound 1$'
check 'the devices are printed' ends 0 '^  display   OpenGL ES 3.1 V3D, 1920x1080$'
as_it_is() { status --json && cmp "$file" "$work/out"; }
check '--json prints the file unchanged' as_it_is
writes 1 true null null
check 'values without a measurement are reported as not measured' ends 0 'heat not measured; watchdog fed; CLOCK NOT SET$'
writes 60 true
check 'a status file that is 60 s old exits with 1' ends 1 'has written no status for 6[0-9]\.[0-9] s'
writes 1 false
check 'a kiosk that cannot save its entries exits with 1' ends 1 'cannot save what it earns'
echo 'something else' >"$file"
check 'a file that is not JSON exits with 65' ends 65 'is not the status file of a kiosk'
echo '{"version": "0.1.0"}' >"$file"
check 'JSON of another kind exits with 65' ends 65 'is not the status file of a kiosk'
rm "$file"
check 'a missing status file exits with 74 and the reason' ends 74 'no kiosk runs as a service here'
check 'a surplus argument is wrong usage' ends 2 'is not understood' now
echo "1..$count"
