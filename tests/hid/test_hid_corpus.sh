#!/bin/bash
# test_hid_corpus.sh -- what kingyoctl hid reads out of real and of hostile report descriptors, row by row.
# README.md says where they are from. Speaks TAP; a line that begins with "# figure:" is shown by run.sh.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
good=tests/hid/good malformed=tests/hid/malformed

# FILES -> one file of rows; the header line must come first, of each, and once.
gather() { # OUT HEADER_OF COMMAND...: for every descriptor in $good
    local out=$1 header file
    header=$(head -1 "$2")
    shift 2
    : >"$out"
    for file in "$good"/descriptors/*.hid; do
        "$@" "$file" >"$work/rows" || { echo "$file: exit $?"; return 1; }
        [ "$(head -1 "$work/rows")" = "$header" ] || { echo "$file: another header"; return 1; }
        tail -n +2 "$work/rows" >>"$out"
    done
}

# What both have, each row as often as it is there. Prints `agreed rows`; fails unless they are the same.
# Values of fields over 32 bits are marked wide, and may be left out.
agree() { # WANTED GOT
    awk -F'\t' -v OFS='\t' '
        FNR == 1 { file++ }
        file == 1 && FNR == 1 { next }
        file == 1 { wanted[$0]++; rows++; if ($8 ~ /^wide/) wide++; next }
        wanted[$0]-- > 0 { agreed++; next }
        { print "# not wanted: " $0 }
        END { for (row in wanted) if (wanted[row] > 0 && row !~ /\twide/) print "# missing: " row
              printf "# figure: %s: %d of %d rows agree", what, agreed, rows
              if (wide) printf ", %d of fields over 32 bits are left out", wide
              print ""; exit rows == 0 || agreed + wide != rows }' what="$3" "$1" "$2"
}
same_order() { # WANTED GOT: order too
    diff <(tail -n +2 "$1" | grep -v "$(printf '\t')wide") "$2"
}
decode() { # Of some devices there is a descriptor and no report, and exit 1 says so.
    "$ctl" hid decode "$1" "$good/reports.tsv"
    local got=$?
    [ $got -eq "$(awk -F'\t' -v id="$(basename "$1" .hid)" '$1 == id && $7 != "short_linux_drops" { found = 1 } END { print !found }' $good/reports.tsv)" ]
}

check 'every real descriptor is read' gather "$work/fields" $good/fields.tsv "$ctl" hid describe
check 'every report of it is decoded' gather "$work/values" $good/values.tsv decode
for of in fields values; do
    agree $good/$of.tsv "$work/$of" "$(ls $good/descriptors | wc -l) real descriptors, $of" >"$work/$of.said"
    agreed=$?
    grep '^# ' "$work/$of.said" | tail -20
    check "$of: every row agrees with what was recorded" [ $agreed -eq 0 ]
    check "$of: in the order of the bits" same_order $good/$of.tsv "$work/$of"
done

# Short, long and unknown reports are all among them; what is short prints nothing.
short_rows() {
    awk -F'\t' 'NR == FNR { if ($7 == "short_linux_drops") { short[$1, $2] = 1; count++ } next }
        ($1, $2) in short { print; bad = 1 } END { exit bad || count < 70 }' $good/reports.tsv "$work/values"
}
check 'a report that is shorter than declared prints no row' short_rows

# ---- Hostile ones: one clear line and 65, or a list that is right; each within two seconds.
count_hostile=0 agreed_hostile=0
while IFS=$'\t' read -r id exit rows says kernel kernel_rows _; do
    timeout 2 "$ctl" hid describe "$malformed/$id.hid" >"$work/out" 2>"$work/err"
    got=$?
    lines=$(($(wc -l <"$work/out")))
    case $exit in
    0) [ $got -eq 0 ] && [ $lines -eq $((rows + 1)) ] && [ ! -s "$work/err" ] &&
        { [ "$kernel" != takes ] || [ "$rows" = "$kernel_rows" ]; } ;;
    *) [ $got -eq 65 ] && [ $lines -eq 0 ] &&
        [ "$(cat "$work/err")" = "kingyoctl hid: $malformed/$id.hid: $says" ] ;;
    esac
    code=$?
    count_hostile=$((count_hostile + 1))
    [ $code -eq 0 ] && agreed_hostile=$((agreed_hostile + 1)) ||
        { echo "# $id: exit $got, $lines lines, $(head -c 200 "$work/err")"; }
done < <(tail -n +2 $malformed/verdicts.tsv)
echo "# figure: $agreed_hostile of $count_hostile hostile descriptors are listed rightly or refused in one line"
check 'each hostile descriptor gets its list or its one line' [ $agreed_hostile -eq $count_hostile ]
check 'none of them was forgotten' [ "$(ls $malformed/*.hid | wc -l)" -eq $count_hostile ]

# Where the kernel lists fields of a hostile one and we do, both lists are the same. It writes the usages
# of an array out and goes by report; we write ranges and go by item.
like_kernel() {
    local id
    for id in $(awk -F'\t' 'NR > 1 && $2 == 0 && $5 == "takes" { print $1 }' $malformed/verdicts.tsv); do
        grep -q "^$id$(printf '\t')" $malformed/linux_fields.tsv || continue
        "$ctl" hid describe "$malformed/$id.hid" | tail -n +2 | cut -f1,3-6,11-13 |
            sed 's/\t0009:0001-0009:0003\t/\t0009:0001,0009:0002,0009:0003,0009:0003\t/' | sort >"$work/ours"
        grep "^$id$(printf '\t')" $malformed/linux_fields.tsv | sort | diff - "$work/ours" || return 1
    done
}
check 'hostile ones that Linux reads too say the same to both' like_kernel
# Those that are legal, and that Linux refuses for another reason, still mean X and Y.
x_and_y() {
    local id
    for id in M08-long-item-valid M09-long-item-zero M58-main-unknown-tags M59-global-unknown-tags \
        M60-local-unknown-tags; do
        "$ctl" hid describe $malformed/$id.hid | tail -n +2 | cut -f3,4,5,11 | tr '\t\n' ' ;' >"$work/ours"
        [ "$(cat "$work/ours")" = '0 0 8 0001:0030;0 8 8 0001:0031;' ] || { echo "$id"; cat "$work/ours"; return 1; }
    done
}
check 'long and reserved items are stepped over' x_and_y
all_x() { # Every bit of M41 is an X; every id of M54 has one.
    "$ctl" hid describe $malformed/M41-usages-1900-one-input.hid |
        awk -F'\t' 'NR > 1 && ($4 != NR - 2 || $11 != "0001:0030") { exit 1 }' &&
        "$ctl" hid describe $malformed/M54-report-ids-255.hid |
        awk -F'\t' 'NR > 1 && ($3 != NR - 1 || $4 != 0 || $11 != "0001:0030") { exit 1 }'
}
check 'as many usages and report ids as there may be are all there' all_x

# ---- Fixed memory: the reader asks for none, and for nothing of the system.
asks_for_nothing() {
    local objects=() part
    for part in hid_descriptor hid_item; do objects+=("$build/drivers/hid/$part.o"); done
    nm -u "${objects[@]}" | awk '$1 == "U" { print $2 }' | grep -vE '^(hid_|core_panic$|mem(set|cpy)$|__stack_chk_fail$)' &&
        return 1
    size -A "${objects[@]}" | awk '$1 ~ /^\.t?(data|bss)$/ && $2 > 0 { print; bad = 1 } END { exit bad }'
}
check 'the reader asks the system for nothing and keeps nothing of its own' asks_for_nothing
echo "1..$count"
