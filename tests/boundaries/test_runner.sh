#!/bin/bash
# test_runner.sh -- what judges the tests is judged: run.sh believes no program that stops halfway, and
# symbols.sh no object that it could not read. Speaks TAP.
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
here=$(dirname "$0")
count=0

# Runs a test program of these LINES under run.sh and expects its VERDICT, the last line.
judged() { # VERDICT TITLE LINES...
    local verdict=$1 title=$2 said
    shift 2
    { echo '#!/bin/bash'; printf '%s\n' "$@"; } >"$work/program"
    chmod +x "$work/program"
    said=$("$here/../run.sh" "$work/results" "$work/program" 2>/dev/null | tail -1)
    count=$((count + 1))
    if [ "$said" = "$verdict" ]; then echo "ok $count - $title"; else
        echo "not ok $count - $title"
        echo "# $said, expected $verdict"
    fi
}

judged '2 passed, 0 failed' 'a whole plan counts' 'echo "ok 1 - a"' 'echo "ok 2 - b"' 'echo "1..2"'
judged '1 passed, 1 failed' 'a failed test counts' 'echo "ok 1 - a"' 'echo "not ok 2 - b"' 'echo "1..2"' 'exit 1'
judged '1 passed, 0 failed' 'a skipped one is none' 'echo "1..2"' 'echo "ok 1 - a"' 'echo "ok 2 - b # SKIP no screen"'
judged '1 passed, 0 failed' 'a test that cmocka skips does not fail' 'echo "1..2"' 'echo "ok 1 - a"' 'echo "not ok 2 # SKIP b"'
judged '1 passed, 1 failed' 'one that ends in peace before its plan' 'echo "1..2"' 'echo "ok 1 - a"' 'exit 0'
judged '1 passed, 1 failed' 'one that never says its plan' 'echo "ok 1 - a"' 'exit 0'
judged '1 passed, 1 failed' 'one that crashes after its last test' 'echo "ok 1 - a"' 'echo "1..1"' 'kill -SEGV $$'
judged '0 passed, 1 failed' 'and one that tests nothing' 'echo "1..0"'

count=$((count + 1))
echo 'no object' >"$work/broken.o"
if "$here/symbols.sh" "$work/broken.o" >"$work/said" 2>&1; then
    echo "not ok $count - symbols.sh passes an object that nm cannot read"
else
    echo "ok $count - symbols.sh refuses an object that nm cannot read"
fi
echo "1..$count"
