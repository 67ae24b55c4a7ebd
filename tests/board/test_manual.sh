#!/bin/bash
# test_manual.sh -- the operator's manual agrees with the program: its Japanese words are those of
# the menu, its links have a target, and its commands and files exist. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
export LC_ALL=C.UTF-8
manual=board/MANUAL.md words=assets/text/ja.txt

# Prints each text in [..] that contains kana or kanji. A path through the menu has one word for
# each level.
japanese() { grep -oP '\[\K[^]\[]*[\x{3040}-\x{30ff}\x{4e00}-\x{9fff}][^]\[]*(?=\])' "$manual" | sed 's/ → /\n/g' | sort -u; }
words_are_the_menus() {
    local word
    japanese >"$work/japanese"
    [ "$(wc -l <"$work/japanese")" -gt 20 ] || return 1
    while read -r word; do
        sed -n 's/^[a-z0-9_]* = //p' "$words" | grep -qF -- "$word" || { echo "the menu lacks $word"; return 1; }
    done <"$work/japanese"
}
# Prints the anchors of the second-level headings of PAGE.
anchors() { sed -n 's/^## //p' "$1" | tr 'A-Z ' 'a-z-' | tr -d ,; }
links_lead_somewhere() {
    local to page
    grep -oE '\]\([^)]+\)' "$manual" | sed 's/^](//; s/)$//' | sort -u >"$work/links"
    while read -r to; do
        case $to in
        \#*) anchors "$manual" | grep -qx -- "${to#\#}" ;;
        *\#*) page=board/${to%%\#*} && [ -e "$page" ] && anchors "$page" | grep -qx -- "${to#*\#}" ;;
        *) [ -e "board/$to" ] ;;
        esac || { echo "$to leads nowhere"; return 1; }
    done <"$work/links"
}
commands_exist() {
    local name
    grep -oE 'kingyoctl [a-z]+' "$manual" | sort -u >"$work/commands"
    [ -s "$work/commands" ] && while read -r _ name; do
        "$ctl" "$name" --help >/dev/null || { echo "kingyoctl has no $name"; return 1; }
    done <"$work/commands"
}
pictures_are_small() { ! find assets/pictures -name 'manual-*' -size +200k | grep .; }

check 'the Japanese words of the manual are those of the menu' words_are_the_menus
check 'the links of the manual have a target' links_lead_somewhere
check 'the commands of the manual exist' commands_exist
check 'the pictures of the manual are under 200 KB' pictures_are_small
echo "1..$count"
