#!/bin/bash
# symbols.sh OBJECT -- checks that the linked core needs only four memory functions and the panic
# hook.
# `make boundaries` runs the script on all objects of the core linked into one. Prints one line for
# each other symbol, or one line if nm cannot read the object.
set -u
undefined=$(nm -u "$1") || { echo "symbols: nm cannot read $1"; exit 1; }
extra=$(awk '{ print $NF }' <<<"$undefined" | grep -vxE 'memcpy|memmove|memset|memcmp|core_panic|')
[ -z "$extra" ] && exit 0
for symbol in $extra; do
    objects=$(find "${1%.o}" -name '*.o' -exec nm -uA {} + | awk -v want="$symbol" '$NF == want' | cut -d: -f1 | tr '\n' ' ')
    echo "$symbol: needed by ${objects}-- the core links against nothing but mem* and core_panic"
done
exit 1
