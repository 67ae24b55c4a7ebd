#!/bin/bash
# test_lines_command.sh -- kingyoctl lines on a machine that may have no GPIO chip: its arguments
# and its errors. tests/vm checks the command on real lines.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"

refuses() { # CODE WORDS ARGUMENTS...: exits with CODE, one line on standard error that has WORDS.
    local expected=$1 words=$2 code
    shift 2
    "$ctl" lines "$@" >"$work/out" 2>"$work/err" </dev/null
    code=$?
    [ "$code" -eq "$expected" ] || { echo "exit $code, not $expected"; cat "$work/err"; return 1; }
    [ "$(wc -l <"$work/err")" -eq 1 ] || { echo 'not one line:'; cat "$work/err"; return 1; }
    grep -qF -- "$words" "$work/err" || { cat "$work/err"; return 1; }
}
# Prints the lines of all chips. Without a chip the command exits with 1 and one sentence. The
# table head is printed in both cases.
lists() {
    "$ctl" lines list >"$work/out" 2>"$work/err"
    local code=$?
    head -1 "$work/out" | grep -q $'^device\tchip\toffset\tname' || return 1
    if ls /dev/gpiochip* >/dev/null 2>&1; then
        [ "$code" -eq 0 ] || grep -q 'none that may be opened' "$work/err"
    else
        [ "$code" -eq 1 ] && grep -q 'no GPIO chip' "$work/err"
    fi
}
helps() { "$ctl" lines --help | grep -q 'kingyoctl lines pulse ROLE=LINE COUNT'; }

echo 1..14
check '--help lists the subcommands' helps
check 'lines list prints the lines or reports that there is no chip' lists
check 'a missing subcommand is wrong usage' refuses 2 'expected list, watch, set or pulse'
check 'an unknown subcommand is wrong usage' refuses 2 "'look' is none of" look
check 'lines list with an argument is wrong usage' refuses 2 'list takes no arguments' list start=A
check 'lines watch without a line is wrong usage' refuses 2 'watch needs ROLE=LINE' watch
check 'an unknown role is wrong usage' refuses 2 "'strat' is not a role" watch strat=A
check 'an unknown flag of a line is wrong usage' refuses 2 "'lo' is none of" watch start=A,lo
check 'two roles on one line are wrong usage' refuses 2 'one line, one role' watch left=A right=A
check '--seconds with text is wrong usage' refuses 2 "--seconds: 'soon' is wrong; expected a whole number" watch start=A --seconds soon
check 'lines set of a button is wrong usage' refuses 2 'start is a button' set start=A on
check 'lines set with a value other than on or off is wrong usage' refuses 2 "not 'bright'" set start-lamp=A bright
check 'lines pulse with a count of 0 is wrong usage' refuses 2 'a count from 1 to' pulse ticket=A 0
check 'a missing line exits with 74 and is named' refuses 74 'NOT_A_LINE_OF_ANY_BOARD' watch start=NOT_A_LINE_OF_ANY_BOARD --seconds 1
