#!/bin/bash
# test_hid_command.sh -- `kingyoctl hid`: which files it reads, one line and an exit code for each
# mistake, rows on a pipe and a picture on a terminal. The corpus is in tests/hid. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
good=tests/hid/good
joypad=006-blaze-joypad
descriptor=$good/descriptors/$joypad.hid

refuses() { # CODE PATTERN WORDS...: Exits with CODE, one line on standard error, and at most one line on standard output.
    local code=$1 pattern=$2
    shift 2
    "$ctl" hid "$@" >"$work/out" 2>"$work/err"
    local got=$?
    cat "$work/err"
    [ $got -eq "$code" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && [ "$(wc -l <"$work/out")" -le 1 ] &&
        grep -qE "^kingyoctl hid: .*$pattern" "$work/err"
}
unhex() { tr -d ' \n' | tr a-f A-F | basenc --base16 -d; }

# ---- Files
same_rows() { # FILE gives the same rows as the file of the corpus, whatever the format of FILE.
    "$ctl" hid describe "$1" | cut -f2- | diff - <("$ctl" hid describe "$descriptor" | cut -f2-)
}
unhex <"$descriptor" >"$work/binary"
tr a-f A-F <"$descriptor" | sed 's/../& /g; s/\(.\{48\}\)/\1\n/g' >"$work/spaced.txt"
{ cat "$descriptor"; printf '\r\n\t '; } >"$work/dos"
check 'a binary descriptor gives the same rows as hex text' same_rows "$work/binary"
check 'hex text in capitals with blanks and line breaks gives the same rows' same_rows "$work/spaced.txt"
check 'hex text with a carriage return gives the same rows' same_rows "$work/dos"
id_of() { [ "$("$ctl" hid describe "$1" | sed -n 2p | cut -f1)" = "$2" ]; }
cp "$work/binary" "$work/my.own.pad.bin"
check 'the id is the file name without its last extension' id_of "$work/my.own.pad.bin" my.own.pad
cp "$work/binary" "$work/.hidden"
check 'a file name that is only an extension is the id' id_of "$work/.hidden" .hidden
echo 0501 >"$work/short.hid"
printf 050 >"$work/half.hid"
: >"$work/empty.hid"
head -c 70000 /dev/zero >"$work/long.hid"
check 'a descriptor without an input field exits with 65' refuses 65 'short.hid: byte 2: no input field' describe "$work/short.hid"
check 'half a byte of hex exits with 65' refuses 65 'half.hid: hex text in which a byte has one digit: letter 3$' describe "$work/half.hid"
printf '05 01 9 02' >"$work/lone.hid"
check 'half a byte in the middle is reported with its position' refuses 65 'one digit: letter 7$' describe "$work/lone.hid"
check 'an empty file exits with 65' refuses 65 'empty.hid: byte 0: empty' describe "$work/empty.hid"
echo '05 01 09 zz' >"$work/typo.hid"
check 'a letter that is not hex is reported with its position' refuses 65 "letter 10, 'z', is not hex" describe "$work/typo.hid"
check 'a file longer than a descriptor exits with 65' refuses 65 'longer than 65535' describe "$work/long.hid"
check 'a missing file exits with 74' refuses 74 'No such file' describe "$work/none.hid"
check 'a folder exits with 74' refuses 74 'Is a directory' describe "$work"
check 'a missing file of reports exits with 74' refuses 74 'none.tsv: No such' decode "$descriptor" "$work/none.tsv"
check 'a folder in place of reports exits with 74' refuses 74 'Is a directory' decode "$descriptor" "$work"
full() { "$ctl" hid describe "$descriptor" 2>"$work/err" >/dev/full; [ $? -eq 74 ] && grep -q 'No space' "$work/err"; }
check 'a full disk exits with 74' full

# ---- Reports
rows() { # FILE COUNT: The command prints COUNT rows of values.
    "$ctl" hid decode "$descriptor" "$1" >"$work/decoded" || return 1
    has_rows "$2"
}
has_rows() {
    [ "$(head -1 "$work/decoded")" = "$(head -1 $good/values.tsv)" ] &&
        [ $(($(wc -l <"$work/decoded") - 1)) -eq "$1" ]
}
# FILE PATTERN: if no report fits, the command prints one line and exits with 1, so that a device
# never seems to be silent.
none() {
    refuses 1 "$2" decode "$descriptor" "$1" && mv "$work/out" "$work/decoded" && has_rows 0
}
whole=$(awk -F'\t' -v id=$joypad '$1 == id && $7 == "ok" { print $3; exit }' $good/reports.tsv)
values=$(awk -F'\t' -v id=$joypad '$1 == id && $2 == 0' $good/values.tsv | wc -l)
head='id\tseq\treport_hex\n'
printf "$head$joypad\t0\t%s\n" "$whole" >"$work/one.tsv"
printf "$head$joypad\t0\t%s" "$whole" >"$work/unended.tsv"
printf "$head$joypad\t0\t%s\n" "${whole%??}" >"$work/cut.tsv"
printf "$head$joypad\t0\t%s\n" "${whole}ff" >"$work/over.tsv"
printf "${head}another\t0\tnot hex\n" >"$work/other.tsv"
printf "$head$joypad\t0\t7f%s\n" "${whole#??}" >"$work/unknown.tsv"
printf "$head$joypad\t0\txyz\n" >"$work/bad.tsv"
printf "$head$joypad\t0\n" >"$work/missing.tsv"
check "hid decode prints one row for each value of a report" rows "$work/one.tsv" "$values"
check 'a report without a final newline is decoded' rows "$work/unended.tsv" "$values"
check 'a report that is one byte too short is rejected' none "$work/cut.tsv" "cut.tsv: reports of id '$joypad': 1, none as long"
check 'a report that is longer than declared is decoded up to its declared length' rows "$work/over.tsv" "$values"
check 'a report of another device is ignored' none "$work/other.tsv" "other.tsv: no report of id '$joypad'"
check 'a report with an undeclared id is rejected' none "$work/unknown.tsv" 'none as long'
check 'an empty file of reports exits with 1' none "$work/empty.hid" 'no report of id'
check 'a descriptor in place of reports exits with 1' none "$descriptor" 'no report of id'
headless() { refuses 65 . decode "$descriptor" "$work/bad.tsv" && [ ! -s "$work/out" ]; }
check 'no table head is printed before an error' headless
check 'a report that is not hex exits with 65 and gives its line' refuses 65 'bad.tsv: line 2: the third column' decode "$descriptor" "$work/bad.tsv"
check 'a row without a report exits with 65 and gives its line' refuses 65 'missing.tsv: line 2: ' decode "$descriptor" "$work/missing.tsv"

# ---- Live input: a recorded file and a pipe are split into reports by the descriptor.
watch_rows() { # FILE REPORTS: Prints the rows of REPORTS reports. The last report has the values of one.tsv.
    "$ctl" hid watch "$1" --descriptor "$descriptor" >"$work/out" || return 1
    [ "$(head -1 "$work/out")" = "$(head -1 $good/values.tsv)$(printf '\ttime_ms')" ] &&
        [ $(($(wc -l <"$work/out") - 1)) -eq $((values * $2)) ] &&
        rows "$work/one.tsv" "$values" &&
        tail -n "$values" "$work/out" | cut -f3-8 | diff - <(tail -n +2 "$work/decoded" | cut -f3-8)
}
for _ in 1 2 3; do echo "$whole" | unhex; done >"$work/three.bin"
check 'hid watch decodes a recorded file to its end' watch_rows "$work/three.bin" 3
through_a_pipe() {
    mkfifo "$work/pipe"
    { head -c 60 "$work/three.bin"; sleep 0.2; tail -c +61 "$work/three.bin"; } >"$work/pipe" &
    watch_rows "$work/pipe" 3
}
check 'hid watch decodes a pipe whose writer pauses within a report' through_a_pipe
head -c 100 "$work/three.bin" >"$work/cut.bin"
printf '\177abc' >"$work/strange.bin"
watch_refuses() { refuses_late 65 "$1" watch "$2" --descriptor "$descriptor"; }
refuses_late() { # The same as refuses, but rows may come before the error.
    local code=$1 pattern=$2
    shift 2
    "$ctl" hid "$@" >"$work/out" 2>"$work/err"
    [ $? -eq "$code" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && grep -qE "$pattern" "$work/err"
}
check 'a recording that ends within a report exits with 65' watch_refuses 'cut.bin: byte 98: ends within a report' "$work/cut.bin"
check 'a recording of another device exits with 65' watch_refuses 'strange.bin: byte 0: no report of this' "$work/strange.bin"
check 'hid watch of a regular file without --descriptor is wrong usage' refuses 2 'is not a device node' watch "$work/three.bin"
check 'a missing device node exits with 74' refuses 74 'No such file' watch /dev/hidraw-none
ends_in_time() {
    mkfifo "$work/silent"
    sleep 5 >"$work/silent" &
    local writer=$! begin=$EPOCHREALTIME
    "$ctl" hid watch "$work/silent" --descriptor "$descriptor" --seconds 1 >"$work/out"
    local code=$?
    kill $writer
    awk -v a="$begin" -v b="$EPOCHREALTIME" 'BEGIN { exit !(b - a > 0.9 && b - a < 3) }' && [ $code -eq 0 ]
}
check 'hid watch --seconds ends after that time' ends_in_time
lists() { "$ctl" hid watch 2>"$work/err" | head -1 | grep -qx "$(printf 'node\tvendor:product\tbus\tdriver\taccess\tname')"; }
check 'hid watch without a device lists the devices' lists
on_a_terminal() {
    script -qec "stty cols 80 rows 24; $ctl hid watch $work/three.bin --descriptor $descriptor" "$work/typed" </dev/null
    cat -v "$work/typed"
    grep -q '3 reports' "$work/typed" && grep -q 'hat' "$work/typed" && grep -q 'button 1 .. button' "$work/typed" &&
        grep -q "$(printf '\033\[?25h\033\[?1049l')" "$work/typed" && ! grep -q 'time_ms' "$work/typed"
}
if command -v script >/dev/null; then
    check 'hid watch on a terminal draws a picture and restores the cursor' on_a_terminal
else
    count=$((count + 1))
    echo "ok $count - hid watch on a terminal draws a picture # skip script(1) is not installed"
fi

# ---- Arguments
for words in '' 'describe' 'describe --frob' 'map --frob' 'describe a b' 'decode a' 'decode a b c' 'walk' 'watch a b' 'watch --seconds 5' \
    'watch a --seconds 0' 'watch a --seconds' 'watch a --descriptor' 'watch a --colour red'; do
    # shellcheck disable=SC2086
    check "'hid $words' is wrong usage" refuses 2 . $words
done
help() { "$ctl" hid --help | grep -q 'kingyoctl hid watch DEVICE' && "$ctl" hid describe --help | grep -q 'decode DESCRIPTOR'; }
check '--help lists the subcommands' help
echo "1..$count"
