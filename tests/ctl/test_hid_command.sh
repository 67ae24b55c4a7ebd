#!/bin/bash
# test_hid_command.sh -- `kingyoctl hid` as its users see it: what it takes for a file, one line and an exit code
# for each mistake, rows on a pipe and a picture on a terminal. tests/hid reads the corpus. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
good=tests/hid/good
joypad=006-blaze-joypad
descriptor=$good/descriptors/$joypad.hid

refuses() { # CODE PATTERN WORDS...: one line on standard error, none on the other
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
same_rows() { # FILE: the same rows as the corpus' own, whatever the file looks like
    "$ctl" hid describe "$1" | cut -f2- | diff - <("$ctl" hid describe "$descriptor" | cut -f2-)
}
unhex <"$descriptor" >"$work/binary"
tr a-f A-F <"$descriptor" | sed 's/../& /g; s/\(.\{48\}\)/\1\n/g' >"$work/spaced.txt"
{ cat "$descriptor"; printf '\r\n\t '; } >"$work/dos"
check 'a binary descriptor says the same as its hex' same_rows "$work/binary"
check 'so does hex in capitals, blanks and lines' same_rows "$work/spaced.txt"
check 'and with a carriage return' same_rows "$work/dos"
id_of() { [ "$("$ctl" hid describe "$1" | sed -n 2p | cut -f1)" = "$2" ]; }
cp "$work/binary" "$work/my.own.pad.bin"
check 'the id is the name without its last extension' id_of "$work/my.own.pad.bin" my.own.pad
cp "$work/binary" "$work/.hidden"
check 'a name that is all extension is an id' id_of "$work/.hidden" .hidden
echo 0501 >"$work/short.hid"
printf 050 >"$work/half.hid"
: >"$work/empty.hid"
head -c 70000 /dev/zero >"$work/long.hid"
check 'what declares no field is bad data' refuses 65 'short.hid: byte 2: no input field' describe "$work/short.hid"
check 'half a byte of hex is bad data' refuses 65 'half.hid: hex text in which a byte has one digit: letter 3$' describe "$work/half.hid"
printf '05 01 9 02' >"$work/lone.hid"
check 'and it is said where, also in its midst' refuses 65 'one digit: letter 7$' describe "$work/lone.hid"
check 'an empty file is bad data' refuses 65 'empty.hid: byte 0: empty' describe "$work/empty.hid"
echo '05 01 09 zz' >"$work/typo.hid"
check 'a typo in hex is told' refuses 65 "letter 10, 'z', is no hex" describe "$work/typo.hid"
check 'so is one longer than a descriptor can be' refuses 65 'longer than 65535' describe "$work/long.hid"
check 'a file that is not there is an I/O error' refuses 74 'No such file' describe "$work/none.hid"
check 'a folder is one' refuses 74 'Is a directory' describe "$work"
check 'reports that are not there too' refuses 74 'none.tsv: No such' decode "$descriptor" "$work/none.tsv"
check 'and a folder of them' refuses 74 'Is a directory' decode "$descriptor" "$work"
full() { "$ctl" hid describe "$descriptor" 2>"$work/err" >/dev/full; [ $? -eq 74 ] && grep -q 'No space' "$work/err"; }
check 'a full disk is an I/O error' full

# ---- Reports
rows() { # FILE COUNT: so many rows of values
    "$ctl" hid decode "$descriptor" "$1" >"$work/decoded" || return 1
    has_rows "$2"
}
has_rows() {
    [ "$(head -1 "$work/decoded")" = "$(head -1 $good/values.tsv)" ] &&
        [ $(($(wc -l <"$work/decoded") - 1)) -eq "$1" ]
}
# FILE PATTERN: nothing in it fits, which is one line and exit 1, never a device that seems to send nothing
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
check "a report's values are rows" rows "$work/one.tsv" "$values"
check 'also without a newline at the end' rows "$work/unended.tsv" "$values"
check 'a report that is a byte too short is none' none "$work/cut.tsv" "cut.tsv: reports of id '$joypad': 1, none as long"
check 'one that is longer is read as far as declared' rows "$work/over.tsv" "$values"
check 'another device'\''s reports are not looked at' none "$work/other.tsv" "other.tsv: no report of id '$joypad'"
check 'an id that nobody declared has no rows' none "$work/unknown.tsv" 'none as long'
check 'an empty file has none' none "$work/empty.hid" 'no report of id'
check 'so has a descriptor that is taken for reports' none "$descriptor" 'no report of id'
headless() { refuses 65 . decode "$descriptor" "$work/bad.tsv" && [ ! -s "$work/out" ]; }
check 'no header stands before what cannot be read' headless
check 'what is no hex is bad data, with its line' refuses 65 'bad.tsv: line 2: the third column' decode "$descriptor" "$work/bad.tsv"
check 'so is a row without a report' refuses 65 'missing.tsv: line 2: ' decode "$descriptor" "$work/missing.tsv"

# ---- Live: a recorded file and a pipe are cut into reports as the descriptor says.
watch_rows() { # FILE REPORTS
    "$ctl" hid watch "$1" --descriptor "$descriptor" >"$work/out" || return 1
    [ "$(head -1 "$work/out")" = "$(head -1 $good/values.tsv)$(printf '\ttime_ms')" ] &&
        [ $(($(wc -l <"$work/out") - 1)) -eq $((values * $2)) ] &&
        rows "$work/one.tsv" "$values" &&
        tail -n "$values" "$work/out" | cut -f3-8 | diff - <(tail -n +2 "$work/decoded" | cut -f3-8)
}
for _ in 1 2 3; do echo "$whole" | unhex; done >"$work/three.bin"
check 'a recorded file is watched to its end' watch_rows "$work/three.bin" 3
through_a_pipe() {
    mkfifo "$work/pipe"
    { head -c 60 "$work/three.bin"; sleep 0.2; tail -c +61 "$work/three.bin"; } >"$work/pipe" &
    watch_rows "$work/pipe" 3
}
check 'a pipe too, wherever its writer pauses' through_a_pipe
head -c 100 "$work/three.bin" >"$work/cut.bin"
printf '\177abc' >"$work/strange.bin"
watch_refuses() { refuses_late 65 "$1" watch "$2" --descriptor "$descriptor"; }
refuses_late() { # As refuses, after rows
    local code=$1 pattern=$2
    shift 2
    "$ctl" hid "$@" >"$work/out" 2>"$work/err"
    [ $? -eq "$code" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && grep -qE "$pattern" "$work/err"
}
check 'a recording that ends within a report is bad data' watch_refuses 'cut.bin: byte 98: ends within a report' "$work/cut.bin"
check 'so is one of another device' watch_refuses 'strange.bin: byte 0: no report of this' "$work/strange.bin"
check 'what is no node needs a descriptor' refuses 2 'no device.s node' watch "$work/three.bin"
check 'a node that is not there is an I/O error' refuses 74 'No such file' watch /dev/hidraw-none
ends_in_time() {
    mkfifo "$work/silent"
    sleep 5 >"$work/silent" &
    local writer=$! begin=$EPOCHREALTIME
    "$ctl" hid watch "$work/silent" --descriptor "$descriptor" --seconds 1 >"$work/out"
    local code=$?
    kill $writer
    awk -v a="$begin" -v b="$EPOCHREALTIME" 'BEGIN { exit !(b - a > 0.9 && b - a < 3) }' && [ $code -eq 0 ]
}
check 'it ends after the seconds that were asked for' ends_in_time
lists() { "$ctl" hid watch 2>"$work/err" | head -1 | grep -qx "$(printf 'node\tvendor:product\tbus\tdriver\taccess\tname')"; }
check 'without a device it lists them' lists
on_a_terminal() {
    script -qec "stty cols 80 rows 24; $ctl hid watch $work/three.bin --descriptor $descriptor" "$work/typed" </dev/null
    cat -v "$work/typed"
    grep -q '3 reports' "$work/typed" && grep -q 'hat' "$work/typed" && grep -q 'button 1 .. button' "$work/typed" &&
        grep -q "$(printf '\033\[?25h\033\[?1049l')" "$work/typed" && ! grep -q 'time_ms' "$work/typed"
}
if command -v script >/dev/null; then
    check 'a terminal gets a picture, and its cursor back' on_a_terminal
else
    count=$((count + 1))
    echo "ok $count - a terminal gets a picture # skip there is no script(1)"
fi

# ---- Words
for words in '' 'describe' 'describe --frob' 'map --frob' 'describe a b' 'decode a' 'decode a b c' 'walk' 'watch a b' 'watch --seconds 5' \
    'watch a --seconds 0' 'watch a --seconds' 'watch a --descriptor' 'watch a --colour red'; do
    # shellcheck disable=SC2086
    check "'hid $words' is wrong usage" refuses 2 . $words
done
help() { "$ctl" hid --help | grep -q 'kingyoctl hid watch DEVICE' && "$ctl" hid describe --help | grep -q 'decode DESCRIPTOR'; }
check 'help says what there is' help
echo "1..$count"
