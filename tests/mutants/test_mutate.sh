#!/bin/bash
# test_mutate.sh -- the mutator changes code alone, one place at a time, and draws the same for the same seed.
# Speaks TAP.
set -u
cd "$(dirname "$0")/../.." || exit 1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
count=0

check() { # STATUS TEXT
    count=$((count + 1))
    [ "$1" -eq 0 ] && echo "ok $count - $2" || echo "not ok $count - $2"
}

cat >"$folder/one.c" <<'END_C'
#define LIMIT 4u /* A < B, 7 */
static int spends(int *purse, int price)
{
    CORE_ASSERT(price > 0);
    if (*purse < price && LIMIT) {
        refuse("1 + 1 < 3", price);
    }
    *purse -= price;
    for (int i = 0; i < 9; i++) {
        tell(i);
    }
    return 1;
}
END_C
${CC:-gcc} -std=c17 -O1 -D_GNU_SOURCE -o "$folder/mutate" tests/mutants/mutate.c || exit 1
"$folder/mutate" draw 1000 1 "$folder/one.c" >"$folder/all"
sites=$(wc -l <"$folder/all")
for ((site = 0; site < sites; site++)); do
    "$folder/mutate" apply "$folder/one.c" "$site" >"$folder/text" 2>/dev/null
    cksum <"$folder/text" >>"$folder/sums"
    diff -U0 "$folder/one.c" "$folder/text" | grep '^+ \|^+#' >>"$folder/lines"
done

[ "$(wc -l <"$folder/lines")" -eq "$sites" ] && [ "$(sort -u "$folder/sums" | wc -l)" -eq "$sites" ]
check $? 'each site changes one line, and each in another way'
has() { grep -qF -- "$1" "$folder/lines"; check $? "$2"; }
has 'if (!(*purse < price && LIMIT))' 'a condition is negated'
has 'if (*purse <= price && LIMIT)' 'a comparison is swapped'
has 'if (*purse < price || LIMIT)' 'a logical operator is swapped'
has '#define LIMIT (4u' 'a constant of a definition is changed'
grep -qE '^\+ +;$' "$folder/lines"
check $? 'a statement is removed'
! grep -qE 'CORE_ASSERT|refuse\("[^"]*[^ 1+<3"]|A <[^ ]|LIMIT .*7 \+|int i = 0; ;' "$folder/lines"
check $? 'assertions, strings, comments and the heads of loops keep their text'

"$folder/mutate" draw 5 7 core/game/*.c >"$folder/first"
"$folder/mutate" draw 5 7 core/game/*.c >"$folder/second"
"$folder/mutate" draw 5 8 core/game/*.c >"$folder/third"
cmp -s "$folder/first" "$folder/second" && ! cmp -s "$folder/first" "$folder/third"
check $? 'the same seed draws the same sites, and another seed draws others'
[ "$(sort -u "$folder/all" | wc -l)" -eq "$sites" ]
check $? 'no site is drawn twice'
! "$folder/mutate" apply "$folder/one.c" "$sites" >/dev/null 2>&1
check $? 'a site that the file does not have is refused'
echo "1..$count"
