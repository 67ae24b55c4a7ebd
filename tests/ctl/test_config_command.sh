#!/bin/bash
# test_config_command.sh -- kingyoctl config, and how `kingyo` treats a configuration with
# mistakes. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
build=$(realpath "$build")
config() { "$build/kingyoctl" config "$@" >"$work/out" 2>"$work/err"; }
ends() { # CODE PATTERN ARGUMENTS...: The command exits with CODE, and one of its outputs matches PATTERN.
    local code=$1 pattern=$2 status
    shift 2
    config "$@"
    status=$?
    cat "$work/out" "$work/err"
    [ $status -eq "$code" ] && grep -qE -- "$pattern" "$work/out" "$work/err"
}
defaults() { config defaults && cp "$work/out" "$work/defaults.conf" && [ ! -s "$work/err" ]; }
check 'config defaults prints a configuration file' defaults
check 'the default configuration has no mistakes' ends 0 'defaults.conf: every line is used$' check "$work/defaults.conf"
changed() { # Removes the comment sign of one key, as the file itself advises.
    sed 's/^#price = 1$/price = 3/' "$work/defaults.conf" >"$work/mine.conf"
    ! cmp -s "$work/mine.conf" "$work/defaults.conf" && ends 0 'every line is used' check "$work/mine.conf"
}
check 'a line without its comment sign changes its key' changed
printf '[money]\nprice = 30\n[sound]\ncolour = red\nprice = 2\n[sond]\n' >"$work/wrong.conf"
check 'a value outside its range is reported with its line and the range' ends 1 'wrong.conf:2: price: wrong value .30.; expected 1 to 20$' check "$work/wrong.conf"
check 'an unknown key is reported with its line' ends 1 'wrong.conf:4: unknown key .colour.' check "$work/wrong.conf"
check 'a key in the wrong section is reported with its section' ends 1 'wrong.conf:5: .price. belongs to \[money\]' check "$work/wrong.conf"
four() { config check "$work/wrong.conf"; [ "$(wc -l <"$work/err")" -eq 4 ] && [ ! -s "$work/out" ]; }
check 'each mistake gives one line' four
check 'a missing file exits with 74' ends 74 'none.conf: No such file' check "$work/none.conf"
check 'config without a subcommand is wrong usage' ends 2 'expected check .* or defaults'
check 'a third argument is wrong usage' ends 2 'expected check' check a b
full() { "$build/kingyoctl" config defaults >/dev/full 2>"$work/err"; [ $? -eq 74 ] && grep -q 'No space' "$work/err"; }
check 'a full disk exits with 74' full

# ---- The kiosk
opens() { # The kiosk opens despite mistakes, reports each wrong line and uses the valid lines.
    printf '[game]\nlanguage = fr\nfish = 20\ntank = festival\nwhat = ever\n' >"$work/stall.conf"
    "$build/kingyo" --config "$work/stall.conf" --demo 5 --window 320x240 --shots "$work/shots" \
        >"$work/stall.out" 2>"$work/stall.err" || { cat "$work/stall.err"; return 1; }
    cat "$work/stall.out" "$work/stall.err"
    grep -q 'stall.conf:2: language: wrong value .fr.; expected ja or en' "$work/stall.err" &&
        grep -q 'stall.conf:5: unknown key' "$work/stall.err" && grep -q ' 20 fish' "$work/stall.out"
}
check 'the kiosk opens with a wrong configuration and reports each mistake' opens
echo "1..$count"
