#!/bin/bash
# test_manual.sh -- the operator's manual agrees with the program: its Japanese words are those of
# the menu, each of its pages can be reached, and its commands exist. Prints TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
export LC_ALL=C.UTF-8
first=board/MANUAL.md words=assets/text/ja.txt
pages=("$first" board/manual/*.md)

# Prints each text in [..] that contains kana or kanji. A path through the menu has one word for
# each level.
japanese() { grep -ohP '\[\K[^]\[]*[\x{3040}-\x{30ff}\x{4e00}-\x{9fff}][^]\[]*(?=\])' "${pages[@]}" | sed 's/ → /\n/g' | sort -u; }
words_are_of_the_menu() {
    local word
    japanese >"$work/japanese"
    [ "$(wc -l <"$work/japanese")" -gt 20 ] || return 1
    while read -r word; do
        sed -n 's/^[a-z0-9_]* = //p' "$words" | grep -qF -- "$word" || { echo "the menu lacks $word"; return 1; }
    done <"$work/japanese"
}
all_pages_are_linked() {
    local page
    for page in "${pages[@]:1}"; do
        grep -qF "](${page#board/})" "$first" || { echo "$first does not link to $page"; return 1; }
    done
}
commands_exist() {
    local name
    grep -ohE 'kingyoctl [a-z]+' "${pages[@]}" | sort -u >"$work/commands"
    [ -s "$work/commands" ] && while read -r _ name; do
        "$ctl" "$name" --help >/dev/null || { echo "kingyoctl has no $name"; return 1; }
    done <"$work/commands"
}
pictures_are_small() { ! find assets/pictures -name 'manual-*' -size +200k | grep .; }

check 'the Japanese words of the manual are those of the menu' words_are_of_the_menu
check 'the first page of the manual links to all its pages' all_pages_are_linked
check 'the commands of the manual exist' commands_exist
check 'the pictures of the manual are under 200 KB' pictures_are_small
echo "1..$count"
