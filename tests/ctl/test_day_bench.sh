#!/bin/bash
# test_day_bench.sh -- the program of `make bench-day`: the same options give the same day, the exit
# status follows the goal, and wrong options are refused. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
bench=$build/tests/bench/day/bench_day

# A day of two visitors with rounds of ten seconds.
day() { # FOLDER OPTION...
    local folder=$work/$1
    shift
    mkdir -p "$folder"
    "$bench" "$folder" --round 10 --visitors 2 --hours 1 --price 2 "$@" >"$folder/out" 2>"$folder/err"
    status=$?
    cat "$folder/out" "$folder/err"
}
# NAME: Prints the output of run NAME without the computation times, which differ between runs.
table() { sed 's/; took .*//' "$work/$1/out"; }

day first --goal 0 >/dev/null
check 'a day that reaches its goal exits with 0' test $status -eq 0
rounds=$(awk '$1 == "all" { print $NF / 2 }' "$work/first/out")
check 'the coins are twice the rounds, of which there are some' \
    grep -q "^  coins: $((2 * ${rounds:-0})), for [1-9][0-9]* paid and 0 free rounds" "$work/first/out"
check 'visitors.tsv has one line for each visitor' test "$(wc -l <"$work/first/visitors.tsv")" -eq 3

day again --goal 0 >/dev/null
check 'the same seed gives the same day' eval \
    'cmp "$work/first/visitors.tsv" "$work/again/visitors.tsv" && [ "$(table first)" = "$(table again)" ]'

# Nobody pays 20 units, so that nobody gets a fish, whatever the core does.
day missed --goal 1 --price 20 >/dev/null
check 'a day that misses its goal exits with 1' test $status -eq 1
check 'the missed goal has its number and advice' eval \
    'grep -q "^NOT SO: 0.0 % of all visitors have a fish of their own (goal 1 %)" "$work/missed/out" && grep -q "^to change: .*lower PRICE" "$work/missed/out"'

day free --goal 0 --price 0 --players 2 >/dev/null
check 'a day of free play with two bowls exits with 0' test $status -eq 0
check 'free play takes no coins' grep -Eq '^  coins: 0, for 0 paid and [1-9][0-9]* free rounds' "$work/free/out"

refused() { # OPTION...: Exits with 2 and one error line.
    "$bench" "$work" "$@" >"$work/out" 2>"$work/err"
    local status=$?
    cat "$work/err"
    [ $status -eq 2 ] && [ "$(wc -l <"$work/err")" -eq 1 ] && [ ! -s "$work/out" ]
}
for option in '--price 21' '--round 9' '--level hard' '--players 5' '--visitors 0' '--hours 25' '--goal 101' '--seed' '--fish 3'; do
    # shellcheck disable=SC2086
    check "$option exits with 2" refused $option
done
echo "1..$count"
