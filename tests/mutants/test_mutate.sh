#!/bin/bash
# test_mutate.sh -- the mutator changes only code, one place at a time, and draws the same places
# for the same seed. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"

cat >"$work/one.c" <<'END_C'
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
${CC:-gcc} -std=c17 -O1 -D_GNU_SOURCE -o "$work/mutate" tests/mutants/mutate.c || exit 1
"$work/mutate" draw 1000 1 "$work/one.c" >"$work/all"
sites=$(wc -l <"$work/all")
for ((site = 0; site < sites; site++)); do
    "$work/mutate" apply "$work/one.c" "$site" >"$work/text" 2>/dev/null
    cksum <"$work/text" >>"$work/sums"
    diff -U0 "$work/one.c" "$work/text" | grep '^+ \|^+#' >>"$work/lines"
done

[ "$(wc -l <"$work/lines")" -eq "$sites" ] && [ "$(sort -u "$work/sums" | wc -l)" -eq "$sites" ]
ok $? 'each site changes one line in a different way'
has() { grep -qF -- "$1" "$work/lines"; ok $? "$2"; }
has 'if (!(*purse < price && LIMIT))' 'a condition is negated'
has 'if (*purse <= price && LIMIT)' 'a comparison is swapped'
has 'if (*purse < price || LIMIT)' 'a logical operator is swapped'
has '#define LIMIT (4u' 'a constant of a definition is changed'
grep -qE '^\+ +;$' "$work/lines"
ok $? 'a mutation removes a statement'
! grep -qE 'CORE_ASSERT|refuse\("[^"]*[^ 1+<3"]|A <[^ ]|LIMIT .*7 \+|int i = 0; ;' "$work/lines"
ok $? 'assertions, strings, comments and loop heads are not mutated'

"$work/mutate" draw 5 7 core/game/*.c core/game/*/*.c >"$work/first"
"$work/mutate" draw 5 7 core/game/*.c core/game/*/*.c >"$work/second"
"$work/mutate" draw 5 8 core/game/*.c core/game/*/*.c >"$work/third"
cmp -s "$work/first" "$work/second" && ! cmp -s "$work/first" "$work/third"
ok $? 'the same seed draws the same sites, and another seed draws others'
[ "$(sort -u "$work/all" | wc -l)" -eq "$sites" ]
ok $? 'no site is drawn twice'
! "$work/mutate" apply "$work/one.c" "$sites" >/dev/null 2>&1
ok $? 'a site that the file does not have is refused'
echo "1..$count"
