#!/bin/bash
# test_technique_bench.sh -- the technique bench itself: each experiment differs in one key,
# kingyoctl can replay each bot of an experiment, and the bench rejects experiments that prove
# nothing. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
bench=$build/tests/bench/technique
bots=$(dirname "$0")/../bench/technique

# ---- The bots of an experiment
keys() { sed 's/[[:space:]]*#.*//; /^[[:space:]]*$/d' "$bots/$1.bot"; }
one_key() { # BETTER WORSE: Both files have the same keys, and exactly one key has another value.
    keys "$1" && keys "$2"
    [ "$(keys "$1" | cut -d= -f1)" = "$(keys "$2" | cut -d= -f1)" ] &&
        [ "$(diff <(keys "$1") <(keys "$2") | grep -c '^<')" = 1 ] && [ "$(diff <(keys "$1") <(keys "$2") | grep -c '^>')" = 1 ]
}
for pair in 'all-wet half-wet' 'slanted flat' 'edge-leading broadside' 'head-first tail-first' 'near-rim centre' \
    'drained-lift fast-lift' 'still-shade chase'; do
    # shellcheck disable=SC2086
    check "${pair/ / and } differ in one key" one_key $pair
done

# ---- One seed
"$bench" 1 "$bots" "$work" >"$work/text" 2>"$work/err"
status=$?
check 'the bench with one seed exits with 1' test $status -eq 1
check 'the bench reports seven experiments' eval '[ "$(grep -c "not shown$" "$work/text")" = 7 ] && grep -q "^NOT SO: 0 of 6 required habits pay" "$work/text"'
check 'the table has one row for each experiment' awk -F'\t' 'NR > 1 && (NF != 9 || $2 != 1 || $8 != 1) { bad = 1 } END { exit bad || NR != 8 }' \
    "$work/technique.tsv"
check 'the difference is that of the means' awk -F'\t' \
    'NR > 1 && (($3 - $4 - $5) ^ 2 > 1e-6) { print; bad = 1 } END { exit bad }' "$work/technique.tsv"
played_alike() { # ARM: Kingyoctl plays the same round from the bot file alone.
    local here there
    here=$(awk -F'\t' -v arm="$1" '$1 == arm && $2 == 0 { print $8, $3 }' "$work/rounds.tsv")
    "$ctl" play --bot "$bots/$1.bot" --mode festival --grade 6 --fish 300 --round-s 60 --seed 0 --json >"$work/one.json"
    there=$(sqlite3 :memory: "select json_extract(j,'\$.rounds[0].state_hash') || ' ' || json_extract(j,'\$.rounds[0].caught')
        from (select readfile('$work/one.json') as j)")
    echo "the bench: $here; kingyoctl play: $there"
    [ -n "$here" ] && [ "$here" = "$there" ]
}
for arm in half-wet tail-first; do
    check "kingyoctl play gives the round of $arm" played_alike "$arm"
done

# ---- Experiments that prove nothing
refused() { # STATUS NEEDLE SEEDS BOTS OUT: Exits with STATUS and one error line that contains NEEDLE.
    local expected=$1 needle=$2 status
    shift 2
    "$bench" "$@" >"$work/out" 2>"$work/err"
    status=$?
    cat "$work/err"
    echo "exit $status"
    [ $status -eq "$expected" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && grep -qF -- "$needle" "$work/err"
}
mkdir "$work/bots"
cp "$bots"/*.bot "$work/bots"
cp "$bots/all-wet.bot" "$work/bots/half-wet.bot"
check 'identical bots exit with 65' refused 65 'half-wet.bot' 1 "$work/bots" "$work"
printf 'base=expert\nwet=2\n' >"$work/bots/half-wet.bot"
check 'an invalid bot exits with 65' refused 65 "$work/bots/half-wet.bot:2: wet" 1 "$work/bots" "$work"
rm "$work/bots/half-wet.bot"
check 'a missing bot exits with 74' refused 74 "$work/bots/half-wet.bot" 1 "$work/bots" "$work"
check '0 seeds are wrong usage' refused 2 'SEEDS' 0 "$bots" "$work"
echo "1..$count"
