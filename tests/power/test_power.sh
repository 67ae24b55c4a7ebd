#!/bin/bash
# test_power.sh -- cuts the power some thousand times, and checks that a card whose syncs have no
# effect is detected. Speaks TAP; run.sh prints lines that begin with "# figure:".
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
power=$build/tests/power/power

nothing_is_lost() {
    "$power" --cuts 3000 --frames 14400 --seed 7
}

failing_calls_lose_nothing() {
    "$power" --cuts 0 --trials 24 --seed 5
}

missing_faults_are_found() { # With --lose-syncs 1 no sync fails.
    "$power" --cuts 0 --trials 4 --seed 5 --lose-syncs 1 >"$work/few"
    local code=$?
    cat "$work/few"
    [ $code = 1 ]
}

lost_sync_is_found() {
    "$power" --cuts 1500 --frames 3600 --seed 7 --lose-syncs 1 >"$work/lost"
    local code=$?
    cat "$work/lost"
    [ $code = 1 ]
}

check 'no acknowledged entry is lost or duplicated by a power cut at any write' nothing_is_lost
sed -n 's/^  \([0-9]* cuts in .*\)/# figure: \1/p' "$work/check.log"
cp "$work/check.log" "$work/cuts"
# A database that other users may read gives a warning at each of the thousands of openings, which would hide the reason
# of a failure.
check 'the openings after the cuts log no warning about access' bash -c '! grep "all users had access" "$1"' - "$work/cuts"
check 'no acknowledged entry is lost when syncs, writes, truncations and renames fail' failing_calls_lose_nothing
sed -n -e 's/^  calls that failed: \(.*\)/# figure: failed calls: \1/p' -e 's/^  \([0-9]* cuts in these .*\)/# figure: \1/p' "$work/check.log"
check 'a run in which too few calls fail is an error' missing_faults_are_found
check 'the error names the calls that did not fail' grep -qx '  too few failed calls: 0 fsync, expected at least 2' "$work/few"
check 'a card whose syncs have no effect is detected' lost_sync_is_found
check 'the number of lost entries of that card is reported' grep -qE '[:,] [1-9][0-9]* (lost|unopenable)' "$work/lost"
echo "1..$count"
