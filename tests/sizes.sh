#!/bin/bash
# sizes.sh BUILD -- prints the sizes of the core's structs, code and constants, and its deepest
# stack frames, as built in BUILD.
set -u
"$1/tests/sizes"
echo
echo 'part                   code bytes   constants'
find "$1/core" -name '*.o' | sed -E "s#^$1/core/##; s#/?[^/]*\$##" | sort -u | while read -r part; do
    size -A "$1/core/$part"/*.o | awk -v part="core/$part" '
        $1 ~ /^\.text/ { code += $2 } $1 ~ /^\.rodata/ { constants += $2 } $1 ~ /^\.(data|bss)$/ { state += $2 }
        END { printf "  %-20s %9d   %9d%s\n", part, code, constants, state ? "   writable: " state : "" }'
done
size -A "$1/core.o" | awk '
    $1 ~ /^\.text/ { code += $2 } $1 ~ /^\.rodata/ { constants += $2 } $1 ~ /^\.(data|bss)$/ { state += $2 }
    END { printf "  %-20s %9d   %9d   with the baked species; static writable state: %d\n", "all", code, constants, state }'
echo
echo 'stack bytes   the deepest frames (gcc -fstack-usage; the core never recurses)'
find "$1/core" -name '*.su' -exec cat {} + | sort -t"$(printf '\t')" -k2 -nr | head -8 |
    awk -F'\t' '{ split($1, at, ":"); printf "  %9d   %s (%s)%s\n", $2, at[4], at[1], $3 == "static" ? "" : " " $3 }'
