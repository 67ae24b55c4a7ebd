#!/bin/bash
# run.sh RESULTS PROGRAM... -- runs test programs that speak TAP and adds up their results.
# Prints one line when a program ends, the whole output of programs that fail, and at last `<n>
# passed, <n> failed` on a line of its own. One program runs on each core at a time. A program
# whose name begins with @ runs alone after the others, because it measures time or drives a whole
# machine. Exits with 1 if any test fails.
#
# A program that ends with 75 lost a part of the machine that it needs, such as the virtual screen
# (tests/e2e/lib.sh). If no other test failed before, it runs once more after a line that says so,
# and the log of the first run stays as NAME.first.tap. A line before the verdict counts the repeats.
set -u
export CMOCKA_MESSAGE_OUTPUT=TAP
limit_s=${TEST_LIMIT_S:-400}

run_one() { # RESULTS PROGRAM
    local name log begin seconds status passed failed skipped planned
    name=$(basename "$2" .sh)
    log=$1/$name.tap
    begin=$EPOCHREALTIME
    timeout --kill-after=5 "$limit_s" "$2" >"$log" 2>&1 </dev/null
    status=$?
    # The last check may have failed because of the loss. A failure before it counts.
    if [ $status -eq 75 ] && ! grep -E '^\s*(not )?ok\b' "$log" | head -n -1 | grep -qE '^\s*not ok\b'; then
        echo "        $name runs again: $(grep -m 1 '^Bail out!' "$log")"
        mv "$log" "$1/$name.first.tap"
        timeout --kill-after=5 "$limit_s" "$2" >"$log" 2>&1 </dev/null
        status=$?
    fi
    seconds=$(awk -v a="$begin" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f", b - a }')
    # cmocka reports a skipped test as `not ok 1 # SKIP name`, other programs as `ok 1 - name # SKIP why`.
    skipped=$(grep -ciE '^\s*(not )?ok\b.*# skip' "$log")
    passed=$(grep -E '^\s*ok\b' "$log" | grep -civE '# skip')
    failed=$(grep -E '^\s*not ok\b' "$log" | grep -civE '# skip')
    planned=$(sed -nE 's/^1\.\.([0-9]+).*/\1/p' "$log" | awk '{ sum += $1 } END { print sum + 0 }')
    if [ "$failed" -eq 0 ] &&
        { [ $status -ne 0 ] || [ "$planned" -eq 0 ] || [ $((passed + skipped)) -ne "$planned" ]; }; then
        failed=1 # The program crashed, timed out, ran no test or stopped before its last test.
    fi
    echo "$passed $failed $skipped" >"$1/$name.count"
    if [ "$failed" -eq 0 ]; then
        printf '  ok    %-28s %4d passed  %6s s\n' "$name" "$passed" "$seconds"
        grep -iE '^\s*(not )?ok\b.*# skip' "$log" | sed -E 's/^\s*(not )?ok[ 0-9]*-*/        skipped:/'
        sed -n 's/^# figure: /        /p' "$log" # Prints the figures that a test measured.
    else
        printf '  FAIL  %-28s %4d passed, %d failed  %6s s\n' "$name" "$passed" "$failed" "$seconds"
        [ $status -eq 124 ] && echo "        stopped after $limit_s s"
        [ $status -gt 1 ] && [ $status -ne 124 ] && echo "        exit status $status"
        [ "$planned" -ne $((passed + failed + skipped)) ] && echo "        the program planned $planned tests"
        tail -n 60 "$log" | sed 's/^/        /'
    fi
    return 0
}
export -f run_one
export limit_s

results=$1
shift
mkdir -p "$results"
rm -f "$results"/*.count "$results"/*.first.tap
side=() alone=()
for program in "$@"; do
    case $program in
    @*) alone+=("${program#@}") ;;
    *) side+=("$program") ;;
    esac
done
if [ ${#side[@]} -gt 0 ]; then
    printf '%s\0' "${side[@]}" | xargs -0 -P "$(nproc)" -I{} bash -c 'run_one "$@"' run "$results" {}
fi
for program in "${alone[@]}"; do
    run_one "$results" "$program"
done
total=$(cat "$results"/*.count 2>/dev/null | awk '{ p += $1; f += $2 } END { print p + 0, f + 0 }')
repeated=$(find "$results" -maxdepth 1 -name '*.first.tap' | wc -l)
echo
[ "$repeated" -eq 0 ] || echo "$repeated repeated: $results/*.first.tap"
echo "${total% *} passed, ${total#* } failed"
[ "${total#* }" -eq 0 ] && [ "${total% *}" -gt 0 ]
