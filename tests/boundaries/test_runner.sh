#!/bin/bash
# test_runner.sh -- run.sh counts a program that stops early as failed, and symbols.sh rejects an
# object that it cannot read. Speaks TAP.
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
here=$(dirname "$0")
count=0

# Runs a test program with these LINES under run.sh and expects VERDICT as the last line.
counts_as() { # VERDICT TITLE LINES...
    local verdict=$1 title=$2 output
    shift 2
    { echo '#!/bin/bash'; printf '%s\n' "$@"; } >"$work/program"
    chmod +x "$work/program"
    output=$("$here/../run.sh" "$work/results" "$work/program" 2>/dev/null | tail -1)
    count=$((count + 1))
    if [ "$output" = "$verdict" ]; then echo "ok $count - $title"; else
        echo "not ok $count - $title"
        echo "# $output, expected $verdict"
    fi
}

counts_as '2 passed, 0 failed' 'a complete plan passes' 'echo "ok 1 - a"' 'echo "ok 2 - b"' 'echo "1..2"'
counts_as '1 passed, 1 failed' 'a failed test is counted as failed' 'echo "ok 1 - a"' 'echo "not ok 2 - b"' 'echo "1..2"' 'exit 1'
counts_as '1 passed, 0 failed' 'a skipped test is not counted' 'echo "1..2"' 'echo "ok 1 - a"' 'echo "ok 2 - b # SKIP no screen"'
counts_as '1 passed, 0 failed' 'a test that cmocka skips does not fail' 'echo "1..2"' 'echo "ok 1 - a"' 'echo "not ok 2 # SKIP b"'
counts_as '1 passed, 1 failed' 'a program that exits with 0 before its last test fails' 'echo "1..2"' 'echo "ok 1 - a"' 'exit 0'
counts_as '1 passed, 1 failed' 'a program without a plan fails' 'echo "ok 1 - a"' 'exit 0'
counts_as '1 passed, 1 failed' 'a program that crashes after its last test fails' 'echo "ok 1 - a"' 'echo "1..1"' 'kill -SEGV $$'
counts_as '0 passed, 1 failed' 'and one that tests nothing' 'echo "1..0"'

count=$((count + 1))
echo 'no object' >"$work/broken.o"
if "$here/symbols.sh" "$work/broken.o" >"$work/log" 2>&1; then
    echo "not ok $count - symbols.sh passes an object that nm cannot read"
else
    echo "ok $count - symbols.sh refuses an object that nm cannot read"
fi
echo "1..$count"
