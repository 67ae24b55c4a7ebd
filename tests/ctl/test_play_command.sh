#!/bin/bash
# test_play_command.sh -- `kingyoctl play`: valid JSON, the same round for the same seed,
# recordings that verify, bots from files, one line for each mistake. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
here=$(dirname "$0")
holds() { # FILE EXPRESSION: SQL expression over j, the JSON of FILE
    [ "$(sqlite3 :memory: "with r as (select readfile('$1') as j) select $2 from r")" = 1 ]
}
value() { # FILE PATH: Prints one value of FILE, which SQLite parses.
    sqlite3 :memory: "select json_extract(readfile('$1'), '\$.$2')"
}
play() { "$ctl" play --round-s 10 "$@"; }

# ---- JSON
play --bot novice --mode festival --rounds 3 --seed 7 --json --record "$work/rec" >"$work/a.json" 2>"$work/err"
keys_are() { # PATH KEYS: The JSON object at PATH has exactly KEYS, in this order.
    local found
    found=$(sqlite3 :memory: "select group_concat(key, ' ') from json_each(readfile('$work/a.json'), '$1')")
    [ "$found" = "$2" ] || { echo "$found"; return 1; }
}
check 'the JSON is valid' holds "$work/a.json" 'json_valid(j)'
check 'the JSON has the documented keys in their order' keys_are '$' 'rounds caught_median caught_p90 caught_max'
check 'each round has the documented keys in their order' keys_are '$.rounds[2]' 'caught scoops fouls torn_at_s sheets hole_area_mm2 state_hash'
check 'the JSON has the requested number of rounds' holds "$work/a.json" "json_array_length(j,'\$.rounds')=3"
check 'each value has its type, and hashes have 16 digits' holds "$work/a.json" \
    "(select count(*) from json_each(j,'\$.rounds') r where json_type(r.value,'\$.caught')='integer'
      and json_type(r.value,'\$.scoops')='integer' and json_type(r.value,'\$.fouls')='integer'
      and json_type(r.value,'\$.torn_at_s') in ('null','real') and json_type(r.value,'\$.hole_area_mm2')='integer'
      and json_extract(r.value,'\$.sheets')=1 and length(json_extract(r.value,'\$.state_hash'))=16)=3"
check 'the totals agree with the rounds' holds "$work/a.json" \
    "(select max(json_extract(value,'\$.caught')) from json_each(j,'\$.rounds'))=json_extract(j,'\$.caught_max')
     and json_extract(j,'\$.caught_median')=(select json_extract(value,'\$.caught') from json_each(j,'\$.rounds')
     order by 1 limit 1 offset 1) and json_extract(j,'\$.caught_p90')<=json_extract(j,'\$.caught_max')
     and json_extract(j,'\$.caught_p90')>=json_extract(j,'\$.caught_median')"
check 'standard error is empty when it is not a terminal' test ! -s "$work/err"

# ---- Determinism
play --bot novice --rounds 3 --seed 7 --json >"$work/b.json"
check 'the same seed gives the same rounds with and without --record' cmp "$work/a.json" "$work/b.json"
play --bot novice --rounds 3 --seed 7 --json --jobs 1 >"$work/b.json"
check '--jobs 1 gives the same rounds as parallel jobs' cmp "$work/a.json" "$work/b.json"
play --bot novice --seed 8 --json >"$work/b.json"
same_hash() { # FILE INDEX FILE INDEX: The rounds at both places have the same state hash.
    local one other
    one=$(value "$1" "rounds[$2].state_hash") other=$(value "$3" "rounds[$4].state_hash")
    echo "$one $other"
    [ -n "$one" ] && [ "$one" = "$other" ]
}
other_hash() { ! same_hash "$@" && [ -n "$(value "$3" "rounds[$4].state_hash")" ]; }
check 'the second round equals the first round of the next seed' same_hash "$work/a.json" 1 "$work/b.json" 0
check 'the first rounds of two seeds differ' other_hash "$work/a.json" 0 "$work/b.json" 0
has_effect() { # OPTIONS...: The options change the state hash of the first round.
    play --bot novice --seed 7 --json "$@" >"$work/b.json" && other_hash "$work/a.json" 0 "$work/b.json" 0
}
for options in '--bot expert' '--grade 7' '--mode practice' '--mode championship' '--fish 50' '--round-s 11'; do
    # shellcheck disable=SC2086
    check "$options changes the round" has_effect $options
done
check 'the default grade of the festival is 6' \
    eval 'play --bot novice --seed 7 --grade 6 --json >"$work/b.json"; same_hash "$work/a.json" 0 "$work/b.json" 0'
play --bot novice --mode championship --seed 7 --json >"$work/c.json"
check 'the default grade of the championship is 5' \
    eval 'play --bot novice --mode championship --seed 7 --grade 5 --json >"$work/b.json"; same_hash "$work/c.json" 0 "$work/b.json" 0'

# ---- Recordings
check '--record writes one file for each round' eval '[ "$(cd "$work/rec" && echo *)" = "round-00001.kgr round-00002.kgr round-00003.kgr" ]'
for i in 1 2 3; do
    check "recording $i verifies, with the printed hash" eval \
        "'$ctl' replay verify '$work/rec/round-0000$i.kgr' | grep -F \"\$(value '$work/a.json' 'rounds[$((i - 1))].state_hash')\""
done

play --bot expert --mode championship --grade 7 --json --record "$work/won" >"$work/c.json"
"$ctl" replay info --json "$work/won/round-00001.kgr" >"$work/info.json"
check 'replay info reports mode, grade, players and rounds' holds "$work/info.json" \
    "json_extract(j,'\$.modes')=json('[{\"mode\":\"championship\",\"grade\":7}]') and json_extract(j,'\$.players')=1
     and json_extract(j,'\$.rounds')=1"
check 'replay info reports the result of the round' eval '[ "$(value "$work/info.json" caught) $(value "$work/info.json" fouls) $(value "$work/info.json" hash)" = \
    "$(value "$work/c.json" "rounds[0].caught") $(value "$work/c.json" "rounds[0].fouls") $(value "$work/c.json" "rounds[0].state_hash")" ]'
check 'the text of replay info names mode and grade' eval '"$ctl" replay info "$work/won/round-00001.kgr" | grep -q "championship with No. 7 paper"'
play --bot novice --level easy --json --record "$work/easy" >"$work/c.json"
"$ctl" replay info --json "$work/easy/round-00001.kgr" >"$work/easy.json"
"$ctl" replay info --json "$here/../replay/format-8.replay" >"$work/old.json"
check 'replay info reports the level, and master for a championship and for a recording without levels' eval \
    '[ "$(value "$work/easy.json" level) $(value "$work/info.json" level) $(value "$work/old.json" level)" = "easy master master" ]'

# ---- Bots from files
printf 'base=novice\n' >"$work/novice.bot"
play --bot "$work/novice.bot" --rounds 3 --seed 7 --json >"$work/b.json"
check 'a bot file with base=novice plays as the built-in novice' cmp "$work/a.json" "$work/b.json"
printf '# slower\nbase=novice\narm_m_s = 0.31 # of 2\n' >"$work/slow.bot"
check 'a bot file with another arm speed plays another round' has_effect --bot "$work/slow.bot"
for bot in "$here"/../bench/technique/*.bot; do
    check "$(basename "$bot") can be played" play --bot "$bot" --fish 20
done

# ---- Text output
play --rounds 2 >"$work/text"
check 'the text has one line for each round and a summary' eval \
    '[ "$(grep -c "^round [12] .*caught.*scoops.*fouls.*hash" "$work/text")" = 2 ] && grep -q "^caught: median .*, p90 .*, most " "$work/text" &&
     [ "$(wc -l <"$work/text")" = 3 ]'
check '--help states the extra seconds at the end of a round' eval \
    '"$ctl" play --help | tr -s " \n" "  " | grep -q "Fish on the paper at the end may still be brought to the bowl, 3 s at most"'
check '--help lists every key of a bot' eval \
    '"$ctl" play --help >"$work/help"; for key in base wet entry_deg glide_deg side place lift hunt fish_max fish_m arm_m_s dip_m_s glide_m_s lift_m_s \
     carry_m_s drain_s patience_s aim_m tremor_m reaction_min_s reaction_max_s; do grep -qw -- "$key" "$work/help" || { echo $key; exit 1; }; done'
check '--help lists every option' eval \
    'for option in bot mode grade rounds seed fish round-s jobs record json; do grep -q -- "--$option " "$work/help" || { echo $option; exit 1; }; done'

# ---- Mistakes: one line that names the mistake, nothing on standard output
mistake() { # STATUS NEEDLE OPTIONS...: Exits with STATUS and one error line that contains NEEDLE.
    local expected=$1 needle=$2 status
    shift 2
    "$ctl" play "$@" >"$work/out" 2>"$work/err"
    status=$?
    cat "$work/err"
    echo "exit $status"
    [ $status -eq "$expected" ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] &&
        grep -qF -- "$needle" "$work/err"
}
bad_bot() { # NEEDLE TEXT: A bot file with TEXT is refused.
    printf '%b' "$2" >"$work/bad.bot"
    mistake 65 "$work/bad.bot$1" --bot "$work/bad.bot"
}
check 'a missing bot file exits with 74' mistake 74 "$work/none.bot" --bot "$work/none.bot"
check 'the error for an unknown bot lists the valid bots' mistake 74 'experrt: No such file or directory; a bot is novice, expert or a FILE' \
    --bot experrt
check 'a folder in place of a bot exits with 74' mistake 74 "$work" --bot "$work"
check 'a misspelt key is reported with its line' bad_bot ":3: 'wett'" 'base=novice\n\nwett=0.5\n'
check 'a value outside its range is reported with the range' bad_bot ":1: wet: '1.5' is wrong; expected 0 to 1" 'wet=1.5\n'
check 'an unknown value is reported with the valid values' bad_bot ":2: side: 'left' is wrong; expected any|head|tail" '#\nside=left\n'
check 'a duplicate key is reported with its first line' bad_bot ':2: wet is in line 1' 'wet=1\nwet=1\n'
check 'a base after other keys is refused' bad_bot ':2: base comes before' 'wet=1\nbase=novice\n'
check 'a line without a value is refused' bad_bot ":1: 'wet' has no '='" 'wet\n'
check 'an empty bot file is refused' bad_bot ': has no key' ''
check 'a binary bot file is refused' bad_bot ':1: the line has more than 199 characters or contains a zero byte' '\0\01\02'
check 'an unknown mode is wrong usage' mistake 2 "--mode: 'lab'" --mode lab
check 'a level of the championship is wrong usage' mistake 2 '--level: a championship has no levels' --mode championship --level easy
check 'an unknown grade is wrong usage' mistake 2 '--grade' --grade 3
check '--rounds 0 is wrong usage' mistake 2 '--rounds' --rounds 0
check 'more fish than the maximum are wrong usage' mistake 2 '1 to ' --fish 2000
check 'a missing value is wrong usage' mistake 2 '--seed needs a value' --seed
check 'an unknown option is wrong usage' mistake 2 --fishes --fishes 3
check 'a round that is too short is wrong usage' mistake 2 '--round-s' --round-s 9
check 'a folder that cannot be created exits with 74' mistake 74 '/dev/null/rec' --record /dev/null/rec
recorded_twice() {
    play --bot novice --json --record "$work/rec" >"$work/out" 2>"$work/err"
    [ $? -eq 74 ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && grep -qF "$work/rec/round-00001.kgr" "$work/err"
}
check 'an existing recording is not overwritten' recorded_twice
full_output() {
    play --json >/dev/full
    [ $? -eq 74 ]
}
check 'a full standard output exits with 74' full_output
echo "1..$count"
