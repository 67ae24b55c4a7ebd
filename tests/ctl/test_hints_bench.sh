#!/bin/bash
# test_hints_bench.sh -- the program of `make bench-hints`: it plays the pair of one sign, and
# refuses unknown signs. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
bench=$build/tests/bench/players/hints

"$bench" 1 normal bowl >"$work/out" 2>"$work/err"
check 'with few seeds the exit status is 0' test $? -eq 0
check 'one pair plays two rounds' grep -q '^hints: 2 of 2 rounds' "$work/err"
check 'the only pair has a row with its catches' grep -Eq '^  bowl .* 0\.00 +[1-9]' "$work/out"

refused() { # WORDS OPTION...: Exits with 2 and one error line that contains WORDS.
    local words=$1
    shift
    "$bench" "$@" >"$work/out" 2>"$work/err"
    local status=$?
    cat "$work/err"
    [ $status -eq 2 ] && [ "$(wc -l <"$work/err")" -eq 1 ] && [ ! -s "$work/out" ] && grep -qF "$words" "$work/err"
}
check 'an unknown sign is named beside the known ones' refused "no sign 'bell'; the signs are move dip" 1 normal bell
check 'an unknown level is refused' refused usage 1 hard
check 'no seeds are refused' refused usage 0 normal
echo "1..$count"
