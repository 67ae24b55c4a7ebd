#!/bin/bash
# test_same_code.sh -- same_code.sh accepts renamed symbols, other texts and moved lines, and
# reports a changed constant, instruction or table and a missing object. Speaks TAP.
set -u
same_code=$(realpath "$(dirname "$0")/same_code.sh")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=0
compile() { # NAME: Compiles the C file on standard input.
    ${CC:-gcc} -O2 -w -D__LINE__=0 -x c -c -o "$work/$1.o" - || {
        echo "Bail out! $1 does not compile"
        exit 1
    }
}
check() { # EXPECTED NAME TITLE [OTHER-NAME]
    count=$((count + 1))
    "$same_code" --objects "$work/${4:-base}.o" "$work/$2.o"
    [ $? -eq "$1" ] && echo "ok $count - $3" || echo "not ok $count - $3"
}
base='static const int lengths[4] = { 3, 1, 4, 1 };
extern void report(const char *text, int line);
int seat_length(int seat) { if (seat > 3) { report("no such seat", __LINE__); } return lengths[seat & 3] + 7; }
extern int prices[4], lower(void), raise(void);
int price_of_two(void) { return prices[2]; }
static int none(void) { return 0; }
int seat_none(void) { return 5; }
const struct { int (*a)(void), (*b)(void); } one = { .a = lower }, own = { none, seat_none };'
compile base <<<"$base"
compile renamed <<<"

${base//seat/player_slot}"
compile constant <<<"${base/+ 7/+ 8}"
compile instruction <<<"${base/+ 7/* 7}"
compile table <<<"${base/4, 1/4, 2}"
compile index <<<"${base/'prices[2]'/prices[3]}"
compile field <<<"${base/.a = lower/.b = lower}"
compile swap <<<"${base/none, seat_none/seat_none, none}"
check 0 base 'an object equals itself'
check 0 renamed 'renamed symbols, another text and moved lines are accepted'
check 1 constant 'a changed constant is reported'
check 1 instruction 'a changed instruction is reported'
check 1 table 'a changed table is reported'
check 1 index 'another element of a table is reported'
check 1 field 'a function in another field is reported'
check 1 swap 'two functions of the object that change places are reported'
check 1 missing 'a missing object is reported'
check 1 missing 'two missing objects are not equal' missing
echo "1..$count"
