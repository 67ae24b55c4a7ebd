#!/bin/bash
# test_power.sh -- the plug is pulled some thousand times; and a card whose syncs are lies is found out.
# Speaks TAP; a line that begins with "# figure:" is shown by run.sh.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
power=$build/tests/power/power

nothing_is_lost() {
    "$power" --cuts 3000 --frames 14400 --seed 7
}

failing_calls_lose_nothing() {
    "$power" --cuts 0 --lives 24 --seed 5
}

a_liar_is_found() {
    "$power" --cuts 1500 --frames 3600 --seed 7 --deaf 1 >"$work/liar"
    local code=$?
    cat "$work/liar"
    [ $code = 1 ]
}

check 'nothing that was promised is lost, and nothing is doubled, wherever the power goes' nothing_is_lost
sed -n 's/^  \([0-9]* cuts in .*\)/# figure: \1/p' "$work/said"
check 'nothing that was promised is lost where syncs, writes, truncations and renames fail' failing_calls_lose_nothing
sed -n -e 's/^  calls that failed: \(.*\)/# figure: failed calls: \1/p' -e 's/^  \([0-9]* cuts in these .*\)/# figure: \1/p' "$work/said"
check 'a card that only says that it has synced is found out' a_liar_is_found
check 'and what it cost is told' grep -qE '[:,] [1-9][0-9]* (lost|unopenable)' "$work/liar"
echo "1..$count"
