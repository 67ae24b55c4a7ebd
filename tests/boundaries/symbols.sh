#!/bin/bash
# symbols.sh OBJECT -- the linked core needs nothing but four memory functions and the panic hook.
#
# Run by `make boundaries` on every object of the core joined into one. One line per symbol too many.
set -u
extra=$(nm -u "$1" | awk '{ print $NF }' | grep -vxE 'memcpy|memmove|memset|memcmp|core_panic')
[ -z "$extra" ] && exit 0
for symbol in $extra; do
    objects=$(find "${1%.o}" -name '*.o' -exec nm -uA {} + | awk -v want="$symbol" '$NF == want' | cut -d: -f1 | tr '\n' ' ')
    echo "$symbol: needed by ${objects}-- the core links against nothing but mem* and core_panic"
done
exit 1
