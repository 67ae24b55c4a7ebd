#!/bin/bash
# includes.sh [FILE...] -- checks which folder may include which, from the compiler's own dependency output.
#
# `make boundaries` runs the script and passes BUILD, CC, CORE_CFLAGS and HOST_CFLAGS. The compiler lists every file
# that each source and each header pulls in, directly or through other headers. FILEs narrow the check to them.
# PAIRS=FILE replaces the compiler: each line of that file is `file included`, as the tests make up.
# exceptions.txt beside the script names the breaches that exist today; EXCEPTIONS=FILE is another list.
# The script prints one line for each breach. The exit status is 1 if there is any.
set -u
here=$(dirname "$0")
build=${BUILD:-build}
exceptions=${EXCEPTIONS:-$here/exceptions.txt}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

own_include=$($CC -print-file-name=include)
[ -d "$own_include" ] || own_include=$($CC -print-resource-dir)/include # The folder of clang.

# Prints `file included` pairs, with paths relative to the top, for the files on standard input.
pairs() { # FLAGS...
    cat >"$work/files"
    # shellcheck disable=SC2086  # CC may have options.
    xargs -r -n 100 $CC "$@" -M <"$work/files" 2>/dev/null | sed -e ':a' -e '/\\$/{N;s/\\\n//;ta' -e '}' |
        awk '{ for (i = 2; i <= NF; i++) print $2, $i }' >"$work/pairs"
    awk 'NR == FNR { read[$1] = 1; next } !($1 in read) { print $1, "(the compiler cannot read it)" }' \
        "$work/pairs" "$work/files"
    awk '$1 != $2' "$work/pairs"
}

files() { # FOLDER: its sources and headers, or those of them that were asked for.
    if [ ${#only[@]} -eq 0 ]; then find "$1" -name '*.[ch]'; else printf '%s\n' "${only[@]}" | grep "^$1/"; fi
}

only=("$@")
if [ -n "${PAIRS:-}" ]; then cat "$PAIRS" >"$work/all"; else
    {
        # shellcheck disable=SC2086
        files core | pairs $CORE_CFLAGS
        # shellcheck disable=SC2086
        { files drivers; files platform; files board; } | pairs $HOST_CFLAGS
    } >"$work/all"
fi

awk -v build="$build" -v own="$own_include" -v list="$exceptions" -v whole=$((${#only[@]} == 0)) \
    -v made_up="${PAIRS:+1}" '
# ---- What a rule compares ----
function folder(path) { sub(/\/[^\/]*$/, "", path); return path }
# The contracts: plain data that crosses between the core and the outside. A species is plain data as well.
function is_contract(path) {
    return path ~ /^core\/(input|output|scene|scene_[a-z]+|view|display_geometry|lab_edit_record|ledger|persistent_state|settings|pin)\.h$/ \
        && path != "core/scene_helpers.h" || path == "core/morph/species.h" || path in contract_data
}
function is_base(path) { return path ~ /^core\/base\// || is_contract(path) }
function is_freestanding(path) {
    return index(path, own "/") == 1 && substr(path, length(own) + 2) ~ \
        /^(float|iso646|limits|stdalign|stdarg|stdbool|stddef|stdint|stdint-gcc|stdnoreturn|__stddef_[a-z_]+|__stdarg_[a-z_]+)\.h$/
}
function is_system(path) { return path ~ /^\// }
function is_baked(path) { return index(path, build "/generated/") == 1 }
# The pure parts of drivers: decoders and parsers that kingyoctl shows.
function is_decoder(path) {
    return path ~ /^drivers\/(hid\/hid_(descriptor|port|mapping)|usb\/usb_(choice|sysfs)|gpio\/[a-z_0-9]+)\.h$/
}
function breach(rule, text) {
    if ((rule, $1, $2) in excepted) { used[rule, $1, $2] = 1; return }
    print $1 ": includes " $2 " -- " rule ": " text
    failed = 1
}

BEGIN {
    # Each line of the list: RULE FILE INCLUDED. Its first line that is no comment: limit NUMBER.
    while ((getline line < list) > 0) {
        sub(/#.*/, "", line)
        n = split(line, word, " ")
        if (n == 0) continue
        if (word[1] == "limit") { limit = word[2]; continue }
        excepted[word[1], word[2], word[3]] = ++count
        if (word[1] == "contract") contract_data[word[3]] = 1
    }
    close(list)
    if (count + 0 > limit + 0) {
        print list ": " count " exceptions, and the limit is " limit " -- the list may only shrink"
        failed = 1
    } else if (count + 0 < limit + 0) {
        print list ": " count + 0 " exceptions: lower the limit of " limit " to this number"
        failed = 1
    }
}

$2 ~ /^\(/ { print $1 ": " $2 " " $3 " " $4 " " $5 " " $6; failed = 1; next }
{ seen[$1] = 1 }

# ---- The core ----
$1 ~ /^core\// && $2 !~ /^core\// && !is_baked($2) && !is_freestanding($2) {
    breach("core", "core includes only core and the freestanding headers")
}
$1 ~ /^core\/base\// && $2 ~ /^core\// && $2 !~ /^core\/base\// {
    breach("base", "core/base includes only core/base")
}
is_contract($1) && $2 ~ /^core\// && !($2 ~ /^core\/base\// || $2 ~ /^core\/[a-z_]+\.h$/ && is_contract($2) || $2 == "core/morph/species.h") && $1 ~ /^core\/[a-z_]+\.h$/ {
    breach("contract", "a contract includes only contracts and core/base")
}
$1 ~ /^core\/(morph|sound)\// && $2 ~ /^core\// && !is_base($2) && folder($2) != folder($1) {
    breach("layer", "core/morph and core/sound include only core/base and the contracts")
}
$1 ~ /^core\/tank\// && $2 ~ /^core\// && !is_base($2) && $2 !~ /^core\/(morph|tank)\// {
    breach("layer", "core/tank includes only core/base, core/morph and the contracts")
}
$1 ~ /^core\/poi\// && $2 ~ /^core\// && !is_base($2) && $2 !~ /^core\/(morph|tank|poi)\// {
    breach("layer", "core/poi includes only core/base, core/morph, core/tank and the contracts")
}
$1 ~ /^core\/game\// && $2 == "core/core.h" {
    breach("game", "core/game is below core/core.h, the whole state")
}
# vision.c reads the scene for the bots, and the bots read only what vision.c found.
$1 ~ /^core\/game\/bot\// && $1 != "core/game/bot/vision.c" && $2 ~ /^core\// && \
    $2 !~ /^core\/game\/bot\// && $2 != "core/poi/pose.h" && !is_base($2) {
    breach("bot", "a bot knows the game by core/game/bot/vision.h alone")
}
$2 ~ /_internal\.h$/ && $2 !~ /^\// && folder($2) != folder($1) {
    breach("internal", "an internal header belongs to its own folder")
}

# ---- Around the core ----
$1 ~ /^drivers\// && !($2 ~ /^(drivers|platform\/os)\// || $2 == "platform/hal.h" || is_base($2) || is_system($2)) {
    breach("driver", "a driver includes only platform/hal.h, platform/os, the contracts of the core, drivers and libraries")
}
$1 ~ /^platform\/os\// && $2 ~ /^(core|drivers|platform|board)\// && $2 !~ /^platform\/os\// && $2 != "platform/hal.h" && !is_base($2) {
    breach("os", "platform/os includes only core/base, the contracts of the core and platform/hal.h")
}
# main.c of the kiosk wires, as board/ does.
$1 ~ /^platform\// && $1 !~ /^platform\/ctl\// && $1 != "platform/kiosk/main.c" && $2 ~ /^(drivers|board|tests)\// {
    breach("wiring", "only board/ and main wire drivers and boards")
}
$1 ~ /^platform\/ctl\// && $1 != "platform/ctl/main.c" && $2 ~ /^(drivers|board|tests)\// && !is_decoder($2) {
    breach("ctl", "platform/ctl includes only the pure decoders of drivers/")
}
$1 !~ /^platform\/ctl\// && $2 ~ /^platform\/ctl\// {
    breach("ctl", "nothing includes platform/ctl")
}
$1 ~ /^platform\// && $1 !~ /^platform\/(kiosk|ctl)\// && $2 ~ /^platform\/kiosk\// {
    breach("kiosk", "only platform/ctl and board/ include the frame loop")
}

END {
    for (key in excepted) {
        split(key, part, SUBSEP)
        if (!(key in used) && !made_up && (whole || part[2] in seen)) {
            print list ": " part[1] " " part[2] " " part[3] " is no breach any more: remove the line, lower the limit"
            failed = 1
        }
    }
    if (!failed && whole && !made_up) print "  ok    includes: " count + 0 " named exceptions (tests/boundaries/exceptions.txt)"
    exit failed
}' "$work/all"
