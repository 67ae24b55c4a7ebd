#!/bin/bash
# device_seeds.sh FOLDER -- what the fuzzers of descriptors and reports begin with: tests/hid, as each wants it.
set -eu
folder=$1
good=tests/hid/good
unhex() { tr -d ' \n' | tr a-f A-F | basenc --base16 -d; }
byte() { printf "\\x$(printf %02x "$1")"; }
[ -e "$folder/made" ] && exit 0
mkdir -p "$folder"/{descriptor,report,rows}
for file in $good/descriptors/*.hid tests/hid/malformed/*.hid; do
    id=$(basename "$file" .hid)
    unhex <"$file" >"$folder/descriptor/$id"
    size=$(stat -c %s "$folder/descriptor/$id")
    [ "$size" -le 2048 ] || continue
    {
        byte $((size % 256))
        byte $((size / 256))
        cat "$folder/descriptor/$id"
        awk -F'\t' -v id="$id" '$1 == id && length($3) <= 256 && n++ < 4 { print $3 }' $good/reports.tsv |
            while read -r hex; do
                byte $((${#hex} / 2))
                echo "$hex" | unhex
            done
    } >"$folder/report/$id"
    {
        printf '%x\n' "$(stat -c %s "$file")"
        cat "$file"
        printf 'id\tseq\treport_hex\n'
        awk -F'\t' -v id="$id" '$1 == id && n++ < 2 { print "d\t" $2 "\t" $3 "\t" $4 }' $good/reports.tsv
    } >"$folder/rows/$id"
done
touch "$folder/made"
