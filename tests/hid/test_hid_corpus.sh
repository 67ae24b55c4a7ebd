#!/bin/bash
# test_hid_corpus.sh -- compares the output of kingyoctl hid for real and malformed report
# descriptors with recorded rows. README.md lists the sources of the descriptors. Speaks TAP;
# run.sh prints lines that begin with "# figure:".
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
good=tests/hid/good malformed=tests/hid/malformed

# Gathers the rows of several files in one file. The header line must come first and once in each.
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

# Prints the number of agreeing rows, with repetitions, and fails unless both files have the same
# rows. Values of fields over 32 bits are marked wide and may be omitted.
agree() { # EXPECTED GOT
    awk -F'\t' -v OFS='\t' '
        FNR == 1 { file++ }
        file == 1 && FNR == 1 { next }
        file == 1 { expected[$0]++; rows++; if ($8 ~ /^wide/) wide++; next }
        expected[$0]-- > 0 { agreed++; next }
        { print "# not expected: " $0 }
        END { for (row in expected) if (expected[row] > 0 && row !~ /\twide/) print "# missing: " row
              printf "# figure: %s: %d of %d rows agree", what, agreed, rows
              if (wide) printf ", %d of fields over 32 bits are left out", wide
              print ""; exit rows == 0 || agreed + wide != rows }' what="$3" "$1" "$2"
}
same_order() { # EXPECTED GOT: Compares the order as well.
    diff <(tail -n +2 "$1" | grep -v "$(printf '\t')wide") "$2"
}
decode() { # Some devices have a descriptor but no report, which gives exit 1.
    "$ctl" hid decode "$1" "$good/reports.tsv"
    local got=$?
    [ $got -eq "$(awk -F'\t' -v id="$(basename "$1" .hid)" '$1 == id && $7 != "short_linux_drops" { found = 1 } END { print !found }' $good/reports.tsv)" ]
}

check 'every real descriptor is parsed' gather "$work/fields" $good/fields.tsv "$ctl" hid describe
check 'every report of a real descriptor is decoded' gather "$work/values" $good/values.tsv decode
for of in fields values; do
    agree $good/$of.tsv "$work/$of" "$(ls $good/descriptors | wc -l) real descriptors, $of" >"$work/$of.output"
    agreed=$?
    grep '^# ' "$work/$of.output" | tail -20
    check "$of: every row agrees with the recorded row" [ $agreed -eq 0 ]
    check "$of: the rows are in the order of the bits" same_order $good/$of.tsv "$work/$of"
done

# The corpus has short, long and unknown reports. A short report prints no row.
short_rows() {
    awk -F'\t' 'NR == FNR { if ($7 == "short_linux_drops") { short[$1, $2] = 1; count++ } next }
        ($1, $2) in short { print; bad = 1 } END { exit bad || count < 70 }' $good/reports.tsv "$work/values"
}
check 'a report that is shorter than declared prints no row' short_rows

# ---- Malformed descriptors: either one line and exit 65 or a correct list, each within two seconds.
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
echo "# figure: $agreed_hostile of $count_hostile hostile descriptors are listed correctly or rejected in one line"
check 'each malformed descriptor gives its list or one error line' [ $agreed_hostile -eq $count_hostile ]
check 'every malformed descriptor is tested' [ "$(ls $malformed/*.hid | wc -l)" -eq $count_hostile ]

# If the kernel and kingyoctl both list the fields of a malformed descriptor, the lists agree. The
# kernel expands the usages of an array and sorts by report; kingyoctl prints ranges and sorts by
# item.
like_kernel() {
    local id
    for id in $(awk -F'\t' 'NR > 1 && $2 == 0 && $5 == "takes" { print $1 }' $malformed/verdicts.tsv); do
        grep -q "^$id$(printf '\t')" $malformed/linux_fields.tsv || continue
        "$ctl" hid describe "$malformed/$id.hid" | tail -n +2 | cut -f1,3-6,11-13 |
            sed 's/\t0009:0001-0009:0003\t/\t0009:0001,0009:0002,0009:0003,0009:0003\t/' | sort >"$work/ours"
        grep "^$id$(printf '\t')" $malformed/linux_fields.tsv | sort | diff - "$work/ours" || return 1
    done
}
check 'malformed descriptors that Linux accepts give the same fields' like_kernel
# Valid descriptors that Linux rejects for another reason still contain X and Y.
x_and_y() {
    local id
    for id in M08-long-item-valid M09-long-item-zero M58-main-unknown-tags M59-global-unknown-tags \
        M60-local-unknown-tags; do
        "$ctl" hid describe $malformed/$id.hid | tail -n +2 | cut -f3,4,5,11 | tr '\t\n' ' ;' >"$work/ours"
        [ "$(cat "$work/ours")" = '0 0 8 0001:0030;0 8 8 0001:0031;' ] || { echo "$id"; cat "$work/ours"; return 1; }
    done
}
check 'long and reserved items are skipped' x_and_y
all_x() { # Every bit of M41 is an X, and every report id of M54 has an X.
    "$ctl" hid describe $malformed/M41-usages-1900-one-input.hid |
        awk -F'\t' 'NR > 1 && ($4 != NR - 2 || $11 != "0001:0030") { exit 1 }' &&
        "$ctl" hid describe $malformed/M54-report-ids-255.hid |
        awk -F'\t' 'NR > 1 && ($3 != NR - 1 || $4 != 0 || $11 != "0001:0030") { exit 1 }'
}
check 'the maximum number of usages and report ids is listed' all_x

# ---- Fixed memory: the reader allocates no memory and makes no system call.
asks_for_nothing() {
    local objects=() part
    for part in hid_descriptor hid_item; do objects+=("$build/drivers/hid/$part.o"); done
    nm -u "${objects[@]}" | awk '$1 == "U" { print $2 }' | grep -vE '^(hid_|core_panic$|mem(set|cpy)$|__stack_chk_fail$)' &&
        return 1
    size -A "${objects[@]}" | awk '$1 ~ /^\.t?(data|bss)$/ && $2 > 0 { print; bad = 1 } END { exit bad }'
}
check 'the reader makes no system call and has no writable data' asks_for_nothing
echo "1..$count"
