#!/bin/bash
# test_runner.sh -- run.sh counts a program that stops early as failed, and repeats only a program
# that lost its screen. symbols.sh rejects an object that it cannot read. Speaks TAP.
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
here=$(dirname "$0")
count=0

says() { # STATUS TITLE
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then echo "ok $count - $2"; else echo "not ok $count - $2"; fi
    return "$1"
}

# Runs a test program with these LINES under run.sh and expects VERDICT as the last line.
counts_as() { # VERDICT TITLE LINES...
    local verdict=$1 title=$2 output
    shift 2
    { echo '#!/bin/bash'; printf '%s\n' "$@"; } >"$work/program"
    chmod +x "$work/program"
    "$here/../run.sh" "$work/results" "$work/program" >"$work/output" 2>/dev/null
    output=$(tail -1 "$work/output")
    [ "$output" = "$verdict" ]
    says $? "$title" || echo "# $output, expected $verdict"
}

counts_as '2 passed, 0 failed' 'a complete plan passes' 'echo "ok 1 - a"' 'echo "ok 2 - b"' 'echo "1..2"'
counts_as '1 passed, 1 failed' 'a failed test is counted as failed' 'echo "ok 1 - a"' 'echo "not ok 2 - b"' 'echo "1..2"' 'exit 1'
counts_as '1 passed, 0 failed' 'a skipped test is not counted' 'echo "1..2"' 'echo "ok 1 - a"' 'echo "ok 2 - b # SKIP no screen"'
counts_as '1 passed, 0 failed' 'a test that cmocka skips does not fail' 'echo "1..2"' 'echo "ok 1 - a"' 'echo "not ok 2 # SKIP b"'
counts_as '1 passed, 1 failed' 'a program that exits with 0 before its last test fails' 'echo "1..2"' 'echo "ok 1 - a"' 'exit 0'
counts_as '1 passed, 1 failed' 'a program without a plan fails' 'echo "ok 1 - a"' 'exit 0'
counts_as '1 passed, 1 failed' 'a program that crashes after its last test fails' 'echo "ok 1 - a"' 'echo "1..1"' 'kill -SEGV $$'
lost='echo "Bail out! The virtual screen has ended."; exit 75'
counts_as '1 passed, 0 failed' 'a program that loses its screen once passes' \
    "[ -e $work/lost ] || { touch $work/lost; echo 'not ok 1 - a'; $lost; }" 'echo "ok 1 - a"' 'echo "1..1"'
grep -qx "1 repeated: $work/results/\*.first.tap" "$work/output" && grep -q '^not ok 1' "$work/results/program.first.tap"
says $? 'its repeat is counted, and its first log kept'
counts_as '0 passed, 1 failed' 'one that loses its screen twice fails' "$lost"
rm "$work/lost"
counts_as '1 passed, 1 failed' 'one that failed before it lost its screen does not run again' \
    "[ ! -e $work/lost ] || { echo 'ok 1 - a'; echo '1..1'; exit 0; }" "touch $work/lost" \
    'echo "not ok 1 - a"' 'echo "ok 2 - b"' "$lost"
counts_as '0 passed, 1 failed' 'and one that tests nothing' 'echo "1..0"'

count=$((count + 1))
echo 'no object' >"$work/broken.o"
if "$here/symbols.sh" "$work/broken.o" >"$work/log" 2>&1; then
    echo "not ok $count - symbols.sh passes an object that nm cannot read"
else
    echo "ok $count - symbols.sh refuses an object that nm cannot read"
fi
echo "1..$count"
