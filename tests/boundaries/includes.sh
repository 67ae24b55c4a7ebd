#!/bin/bash
# includes.sh [FILE...] -- checks which folder may include which, from the compiler's own dependency output.
#
# `make boundaries` runs the script and passes BUILD, CC, CORE_CFLAGS and HOST_CFLAGS. The compiler lists every file
# that each source and each header pulls in, directly or through other headers. FILEs narrow the check to them.
# The script also reads each `#include "..."` (kind `direct`), and each use of a member of the core's state outside the
# core (kind `state`).
# PAIRS=FILE replaces the output of the compiler and the search: each line of FILE is `file included [kind]`. The
# tests use such lists.
# exceptions.txt beside the script names the breaches that exist today; EXCEPTIONS=FILE is another list.
# public_headers.txt lists the headers that folders of the core offer; PUBLIC=FILE is another list. The table in
# platform/README.md states which folder of the platform includes which; TABLE=FILE is another page.
# The script prints one line for each breach. The exit status is 1 if there is any.
set -u
here=$(dirname "$0")
build=${BUILD:-build}
exceptions=${EXCEPTIONS:-$here/exceptions.txt}
public=${PUBLIC:-$here/public_headers.txt}
table=${TABLE:-$here/../../platform/README.md}
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

# Prints `file included direct` for each #include of a file of the tree.
direct() { # FILE...
    grep -HoE '^[ \t]*#[ \t]*include[ \t]*"(core|drivers|platform|board|assets)/[^"]+"' "$@" /dev/null |
        sed -E 's/:[^"]*"/ /; s/"$/ direct/'
}

# Prints `file core.NAME state` for each use of a member or a type that holds the state of the game or of the world, which
# only the core may know. Comments and strings do not count.
state() { # FILE...
    awk 'FNR == 1 { open = 0 }
        {
            gsub(/"([^"\\]|\\.)*"/, "")
            if (open && !sub(/^([^*]|\*+[^*\/])*\*+\//, "")) next
            open = 0
            gsub(/\/\*([^*]|\*+[^*\/])*\*+\//, "")
            if (sub(/\/\*.*/, "")) open = 1
            while (match($0, /(->|\.|struct )(game|world)([^A-Za-z0-9_]|$)/)) {
                name = substr($0, RSTART, RLENGTH)
                gsub(/struct|[^a-z]/, "", name)
                print FILENAME, "core." name, "state"
                $0 = substr($0, RSTART + RLENGTH)
            }
        }' "$@" /dev/null | sort -u
}

only=("$@")
if [ -n "${PAIRS:-}" ]; then cat "$PAIRS" >"$work/all"; else
    {
        # shellcheck disable=SC2086
        files core | pairs $CORE_CFLAGS
        # shellcheck disable=SC2086
        { files drivers; files platform; files board; files assets; } | tee "$work/outside" | pairs $HOST_CFLAGS
        mapfile -t outside <"$work/outside"
        mapfile -t core < <(files core)
        direct "${core[@]}" "${outside[@]}"
        state "${outside[@]}"
    } >"$work/all"
fi

awk -v build="$build" -v own="$own_include" -v list="$exceptions" -v public="$public" -v table="$table" -v whole=$((${#only[@]} == 0)) \
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
# The folder of the platform that a rule names: the first one below platform/, or "." for its own files.
function platform_folder(path,   name) {
    return split(path, name, "/") == 2 ? "." : name[2]
}
# The class of a header in public_headers.txt must include the user: a folder of the core, kingyoctl, or the platform.
function may_use(who, path) {
    return path ~ /^core\// || who == "all" || who == "ctl" && path ~ /^(platform\/ctl|board|assets)\//
}
function breach(rule, text) {
    if ((rule, $1, $2) in excepted) { used[rule, $1, $2] = 1; return }
    print $1 ": " ($3 == "state" ? "names " : "includes ") $2 " -- " rule ": " text
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
    while ((getline line < public) > 0) {
        sub(/#.*/, "", line)
        if (split(line, word, " ") == 2) offered[word[2]] = word[1]
    }
    close(public)
    # Rows of the table: | `folder` | text | `allowed`, `allowed` |
    while ((getline line < table) > 0) {
        if (split(line, cell, "|") != 5 || cell[2] !~ /`/) continue
        gsub(/[` ]/, "", cell[2])
        gsub(/[` ]/, "", cell[4])
        row[cell[2]] = "," cell[4] ","
    }
    close(table)
    if (length(row) == 0) { print table ": no table of folders"; failed = 1 }
    if (count + 0 > limit + 0) {
        print list ": " count " exceptions, and the limit is " limit " -- the list may only shrink"
        failed = 1
    } else if (count + 0 < limit + 0) {
        print list ": " count + 0 " exceptions: lower the limit of " limit " to this number"
        failed = 1
    }
}

# ---- Direct includes ----
$3 == "state" {
    breach("state", "code around the core calls functions of core/core.h, and does not read the game or the world")
    next
}
$3 == "direct" && $2 ~ /^core\// && !is_base($2) && index($1, folder($2) "/") != 1 {
    if ($2 in offered) seen_outside[$2] = 1
    if (!($2 in offered) || !may_use(offered[$2], $1)) {
        breach("private", "public_headers.txt does not offer this header to this folder")
    }
}
$3 == "direct" && $1 ~ /^platform\// && $2 ~ /^platform\// && platform_folder($1) != platform_folder($2) {
    allowed = row[platform_folder($1)]
    if (!index(allowed, "," platform_folder($2) ",") && !(platform_folder($2) == "." && \
        (index(allowed, ",*.h,") || index(allowed, "," substr($2, 10) ",")))) {
        breach("platform", "platform/README.md does not let " platform_folder($1) " include this")
    }
}
$3 == "direct" { next }

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
# vision.c reads the state for the bots, and the bots read only what vision.c found. Records that only a contract
# includes (contract_data) are state as well. paper_patch.h does not include the sheet.
$1 ~ /^core\/game\/bot\// && $1 != "core/game/bot/vision.c" && $2 ~ /^core\// && \
    $2 !~ /^core\/(game\/bot\/|poi\/(pose|paper\/paper_patch)\.h$)/ && (!is_base($2) || $2 in contract_data) {
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
# main.c of the kiosk connects the modules, as board/ does.
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

# ---- Build tools ----
$1 ~ /^assets\// && !($2 ~ /^(assets|platform\/os|platform\/species)\// || is_base($2) || $2 == "core/morph/morph.h" || is_system($2) || is_baked($2)) {
    breach("assets", "a build tool includes only assets, platform/os, platform/species, contracts and libraries")
}
$1 !~ /^assets\// && $2 ~ /^assets\// && !($1 ~ /^(platform\/(render|ctl)|board)\// && $2 == "assets/font.h") {
    breach("assets", "only the format of the fonts leaves assets/, for the renderer and its users")
}

END {
    for (header in offered) {
        if (!(header in seen_outside) && whole && !made_up) {
            print public ": " header " is not included from outside its folder any more: remove the line"
            failed = 1
        }
    }
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
