#!/bin/bash
# A few seconds of each full tank, calm and dragged through: nothing is in anything else. The ten
# minutes of `make soak` are the same program.
out=$("${BUILD:-build}/tests/soak/soak" "${SOAK_SECONDS:-8}")
failed=$?
n=0
echo "1..6"
while read -r line; do
    n=$((n + 1))
    case $line in
    *"NOT OK") echo "not ok $n - $line" ;;
    *) echo "ok $n - $line" ;;
    esac
done < <(tail -n +2 <<<"$out")
[ "$n" -eq 6 ] && exit $failed
exit 1
