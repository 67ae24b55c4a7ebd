#!/bin/bash
# device_seeds.sh FOLDER -- makes the seeds of the device fuzzers from tests/hid, in the input
# format of each fuzzer.
set -eu
folder=$1
good=tests/hid/good
unhex() { tr -d ' \n' | tr a-f A-F | basenc --base16 -d; }
byte() { printf "\\x$(printf %02x "$1")"; }
[ "$folder/made" -nt "$0" ] && exit 0
mkdir -p "$folder"/{descriptor,report,rows,pose_decoder,map_text,learn,mapping_file,wires}
word() { byte $(($1 % 256)); byte $(($1 / 256)); }
for file in $good/descriptors/*.hid tests/hid/malformed/*.hid; do
    id=$(basename "$file" .hid)
    unhex <"$file" >"$folder/descriptor/$id"
    size=$(stat -c %s "$folder/descriptor/$id")
    [ "$size" -le 2048 ] || continue
    {
        word "$size"
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
# A controller: its ids, its descriptor, the selected mapping, and its reports 8 ms apart.
while IFS=$'\t' read -r id vendor product _; do
    [[ $vendor$product =~ ^[0-9a-f]{8}$ ]] || vendor=0000 product=0000
    {
        word $((16#$vendor))
        word $((16#$product))
        word "$(stat -c %s "$folder/descriptor/$id")"
        cat "$folder/descriptor/$id"
        echo
        awk -F'\t' -v id="$id" '$1 == id && length($3) <= 256 && n++ < 8 { print $3 }' $good/reports.tsv |
            while read -r hex; do
                byte 16
                byte $((${#hex} / 2))
                echo "$hex" | unhex
            done
    } >"$folder/pose_decoder/$id"
done < <(tail -n +2 $good/provenance.tsv)

cat >"$folder/map_text/learned" <<'END'
learned fly x=rate:1:u8@0:128..255~12 dip=press:1:u1@37:0..1 ok=press:0:u8@16:0..1/00070028
END
echo 'known pointer trembles x=place:1:s16@8:-32767..32767 z=place:1:s16@24:32767..-32767 in-range=press:1:u1@40:0..1' \
    >"$folder/map_text/known"
echo 'own pose feels tilt=step:2:s8@0:0..1 hat=hat:2:u4@8:0..7' >"$folder/map_text/own"
{
    echo 'kingyo poi 1'
    echo '054c:0ce6:A0-1'
    cat "$folder/map_text/learned"
} >"$folder/mapping_file/one.poi"

# A joystick with reports of three bytes that is centred, moves left, right, away and near, and is
# pressed.
joystick=05010904a101093009311500 joystick+=26ff0075089502810205091901290815002501750195088102c0
{
    word $((${#joystick} / 2))
    echo $joystick | unhex
    for step in 808000 0a8000 f68000 800a00 80f600 808001; do
        for report in 808000 $step $step; do
            byte 64
            byte 3
            echo $report | unhex
        done
        byte 255
    done
} >"$folder/learn/joystick"
cat >"$folder/wires/cabinet" <<'END'
start=BTN_START,low,up,debounce=5ms
coin=pinctrl-bcm2711:17,window=15ms-250ms
ticket=TICKET,high,pulse=100ms/100ms
start_lamp=gpio-sim.0:4,float
plays 057e:2009:A0-1
rests 1209:0001
END
rm -rf "$folder/live"
cp -r "$folder/report" "$folder/live"
touch "$folder/made"
