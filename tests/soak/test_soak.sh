#!/bin/bash
# test_soak.sh -- simulates each full tank for a few seconds, calm and with a poi that is dragged
# through it, and checks that no body overlaps another. `make soak` runs the same program for ten
# minutes. Speaks TAP.
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
