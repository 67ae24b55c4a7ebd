#!/bin/bash
# test_cabinet.sh -- the pins of the cabinet agree between the page, the picture, the overlays,
# lines.conf and the boot files. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
cabinet=board/cabinet

# The GPIO of each pin of the 40-pin header (Raspberry Pi documentation).
header='3:2 5:3 7:4 8:14 10:15 11:17 12:18 13:27 15:22 16:23 18:24 19:10 21:9 22:25 23:11 24:8 26:7 27:0 28:1
29:5 31:6 32:12 33:13 35:19 36:16 37:26 38:20 40:21'

# `ROLE PIN GPIO` for each row of the page's table.
awk -F' *[|] *' '/^[|] [A-Z]/ && $3 ~ /^[0-9]+$/ { print $2, $3, $4 }' "$cabinet/README.md" | sort >"$work/page"

pins_are_the_headers() {
    [ "$(wc -l <"$work/page")" = 15 ] || return 1
    while read -r role pin gpio; do
        [[ " ${header//$'\n'/ } " == *" $pin:$gpio "* ]] || { echo "$role: pin $pin is not GPIO$gpio"; return 1; }
    done <"$work/page"
}

picture_agrees() {
    xmllint --noout "$cabinet/wiring.svg" || return 1
    while read -r role pin gpio; do
        grep -q ">$pin</text>" "$cabinet/wiring.svg" && grep -q ">GPIO$gpio</text>" "$cabinet/wiring.svg" &&
            grep -qE ">${role}[ <]" "$cabinet/wiring.svg" || {
            echo "$role is not in the picture"; return 1; }
    done <"$work/page"
}

overlay_agrees() { # BOARD
    dtc -q -@ -I dts -O dtb -o "$work/overlay" "board/$1/kingyo-cabinet.dts" || return 1
    fdtget "$work/overlay" /fragment@0/__overlay__ gpio-line-names | tr ' ' '\n' >"$work/names"
    while read -r role _ gpio; do
        [ "$(sed -n "$((gpio + 1))p" "$work/names")" = "$role" ] || { echo "$1: GPIO$gpio is not $role"; return 1; }
    done <"$work/page"
    [ "$(sort "$work/names" | uniq -d | wc -l)" = 0 ]
}

boot_file_agrees() { # BOARD
    local inputs outputs
    inputs=$(awk '$1 !~ /^(START_LAMP|COIN_LOCKOUT|TICKET|COIN_COUNTER)$/ { print $3 }' "$work/page" | sort -n | xargs)
    outputs=$(awk '$1 ~ /^(START_LAMP|TICKET|COIN_COUNTER)$/ { print $3 }' "$work/page" | sort -n | xargs)
    [ "$(sed -n 's/^gpio=\(.*\)=ip,pu$/\1/p' "board/$1/config.txt" | tr , '\n' | sort -n | xargs)" = "$inputs" ] &&
        [ "$(sed -n 's/^gpio=\(.*\)=op,dl$/\1/p' "board/$1/config.txt" | tr , '\n' | sort -n | xargs)" = "$outputs" ] &&
        grep -qx "gpio=$(awk '$1 == "COIN_LOCKOUT" { print $3 }' "$work/page")=ip,pd" "board/$1/config.txt" &&
        [ "$(wc -l <"board/$1/cmdline.txt")" = 1 ] && mode_fits_gpu "$1"
}

# The mode of the screen is the one that the GPU of the board draws at 60 Hz (tests/FIGURES.md).
mode_fits_gpu() { # BOARD
    local mode=1920x1080
    [ "$1" != rpi4 ] || mode=1280x720
    grep -q "^video=HDMI-A-1:$mode@60D " "board/$1/cmdline.txt"
}

# Every role of the cabinet has its line, and the kiosk accepts each line.
lines_agree() {
    local line lines=()
    "$ctl" config check "$cabinet/lines.conf" >"$work/lines" 2>&1 || { cat "$work/lines"; return 1; }
    while read -r line; do
        lines+=("$line")
        line=${line#*=}
        grep -q "^${line%%,*} " "$work/page" || { echo "$line is not on the page"; return 1; }
    done < <(sed -n 's/^line = //p' "$cabinet/lines.conf")
    [ "${#lines[@]}" = 15 ] || return 1
    timeout 20 "$ctl" lines watch "${lines[@]}" --seconds 1 >"$work/lines" 2>&1
    ! grep -qE "is no (role|word)|same line" "$work/lines" || { cat "$work/lines"; return 1; }
}

check 'the pins of the page agree with the 40-pin header' pins_are_the_headers
check 'the picture has every pin and every role' picture_agrees
for board in rpi4 rpi5; do
    check "the overlay of $board names each line after its role" overlay_agrees "$board"
    check "the boot file of $board pulls each pin to its rest level" boot_file_agrees "$board"
done
check 'lines.conf has every role of the cabinet' lines_agree
echo "1..$count"
