#!/bin/bash
# includes.sh [FILE...] -- who may include whom, from the compiler's own list of what each file really pulls in.
#
# Run by `make boundaries`, which passes CC, CORE_CFLAGS and HOST_CFLAGS. Headers are asked as well as
# sources, so that one nobody includes yet is held to the rule too. FILEs narrow the look to them. One
# line per breach; exit 1 on any.
set -u
only=" $* "
files() { # FOLDER: its sources and headers, but for the one main() that wires.
    find "$1" -name '*.[ch]' ! -path 'platform/kiosk/main.c' ! -path 'platform/ctl/main.c' 2>/dev/null | sort |
        while read -r file; do
            if [ "$only" = '  ' ] || [[ $only == *" $file "* ]]; then echo "$file"; fi
        done
}
own_include=$($CC -print-file-name=include)
[ -d "$own_include" ] || own_include=$($CC -print-resource-dir)/include # clang calls it so
freestanding='(float|iso646|limits|stdalign|stdarg|stdbool|stddef|stdint|stdint-gcc|stdnoreturn|__stddef_[a-z_]+|__stdarg_[a-z_]+)\.h'
# A species is plain data: what scenes and saved graphs are made of. So is what the store remembers.
contracts='core/(input|output|scene|scene_[a-z]+|view|display_geometry|lab_edit_record|ledger|persistent_state|settings)\.h|core/game/(accounting/audits|ranking/ranking)\.h'
contracts+='|core/poi/paper/sheet\.h|core/morph/species\.h|core/base/[a-z_0-9]+\.h'

# Prints `file included` pairs, paths relative to the top, for the sources on standard input.
pairs() { # FLAGS...
    local file
    while read -r file; do
        $CC "$@" -M "$file" 2>&1 | tr -s ' \\' '\n' |
            awk -v file="$file" 'NF && $1 !~ /:$/ && $1 != file { print file, $1 }'
        [ "${PIPESTATUS[0]}" -eq 0 ] || echo "$file (the compiler cannot read it)"
    done
}

# Keeps the pairs whose second part does not match, and says which rule it breaks.
breach() { # ALLOWED RULE
    awk -v allowed="^($1)\$" -v rule="$2" '$2 !~ allowed { print $1 ": includes " $2 " -- " rule }'
}

core_rule='core includes only core and the freestanding headers'
bot_rule='a bot knows the stall by core/game/bot/vision.h alone'
bot_files='/bot/[a-z_]+\.h$|/bot/(bot|bot_[a-z]+|paper_patch|snapshot|targeting|technique)\.c$'
bot_headers='core/game/bot/[a-z_]+\.h|core/poi/pose\.h'
driver_rule="a driver includes only platform/hal.h, platform/os, the core's contracts, drivers and libraries"
shell_rule='only board/ and main wire drivers and boards; kingyoctl may show a pure decoder, and GPIO lines'
decoders='drivers/(hid/hid_(descriptor|port|mapping|mapping_store_text)|usb/usb_(choice|choice_file|sysfs)|gpio/[a-z_]+)\.h'

breaches=$({
    # shellcheck disable=SC2086
    files core | pairs $CORE_CFLAGS |
        breach "(core|$BUILD/generated)/.*|$own_include/$freestanding" "$core_rule"
    # shellcheck disable=SC2086
    files core/game | grep -E "$bot_files" | pairs $CORE_CFLAGS |
        breach "$bot_headers|$contracts|$own_include/$freestanding" "$bot_rule"
    # shellcheck disable=SC2086
    files drivers | pairs $HOST_CFLAGS |
        breach "platform/hal\.h|$contracts|platform/os/.*|drivers/.*|/.*" "$driver_rule"
    # shellcheck disable=SC2086
    files platform | pairs $HOST_CFLAGS |
        breach "(core|platform|assets|$BUILD/generated)/.*|$decoders|/.*" "$shell_rule"
})
if [ -n "$breaches" ]; then
    echo "$breaches"
    exit 1
fi
