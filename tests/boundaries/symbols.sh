#!/bin/bash
# symbols.sh OBJECT -- the linked core needs nothing but four memory functions and the panic hook.
#
# Run by `make boundaries` on every object of the core joined into one. One line per symbol too many, or
# one when nm cannot read the object at all.
set -u
undefined=$(nm -u "$1") || { echo "symbols: nm cannot read $1"; exit 1; }
extra=$(awk '{ print $NF }' <<<"$undefined" | grep -vxE 'memcpy|memmove|memset|memcmp|core_panic|')
[ -z "$extra" ] && exit 0
for symbol in $extra; do
    objects=$(find "${1%.o}" -name '*.o' -exec nm -uA {} + | awk -v want="$symbol" '$NF == want' | cut -d: -f1 | tr '\n' ' ')
    echo "$symbol: needed by ${objects}-- the core links against nothing but mem* and core_panic"
done
exit 1
