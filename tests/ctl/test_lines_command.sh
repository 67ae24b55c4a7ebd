#!/bin/bash
# test_lines_command.sh -- kingyoctl lines where there may be no GPIO chip at all: what it asks for, and what it
# says of what it cannot have. What it does on true lines is proven in a virtual machine.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"

refuses() { # CODE WORDS ARGUMENTS...: exits with CODE, one line on standard error that has WORDS.
    local wanted=$1 words=$2 code
    shift 2
    "$ctl" lines "$@" >"$work/out" 2>"$work/err" </dev/null
    code=$?
    [ "$code" -eq "$wanted" ] || { echo "exit $code, not $wanted"; cat "$work/err"; return 1; }
    [ "$(wc -l <"$work/err")" -eq 1 ] || { echo 'not one line:'; cat "$work/err"; return 1; }
    grep -qF -- "$words" "$work/err" || { cat "$work/err"; return 1; }
}
lists() { # Lines where there are chips, a sentence and exit 1 where there are none; the head in any case.
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
check 'help names its subcommands' helps
check 'the list says what there is, or that there is nothing' lists
check 'a subcommand is wanted' refuses 2 'expected list, watch, set or pulse'
check 'an unknown one is told' refuses 2 "'look' is none of" look
check 'list wants no words' refuses 2 'list takes no arguments' list start=A
check 'watch wants a wire' refuses 2 'watch needs ROLE=LINE' watch
check 'a role that is none is told' refuses 2 "'strat' is no role" watch strat=A
check 'a word that is none is told' refuses 2 "'lo' is none of" watch start=A,lo
check 'two roles on one line are told' refuses 2 'one line, one role' watch left=A right=A
check 'seconds are a number' refuses 2 "--seconds: 'soon' is wrong; expected a whole number" watch start=A --seconds soon
check 'a button cannot be switched' refuses 2 'start is a button' set start=A on
check 'a lamp is on or off' refuses 2 "not 'bright'" set start-lamp=A bright
check 'pulses are counted' refuses 2 'a count from 1 to' pulse ticket=A 0
check 'a line that is not there is told, with what to do' refuses 74 'NOT_A_LINE_OF_ANY_BOARD' watch start=NOT_A_LINE_OF_ANY_BOARD --seconds 1
