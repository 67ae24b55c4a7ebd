#!/bin/bash
# test_play_command.sh -- `kingyoctl play` as its users see it: JSON that another program reads, the same
# round again for the same seed, recordings that are true, bots from files, one line for each mistake.
# Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
here=$(dirname "$0")
holds() { # FILE EXPRESSION: SQL over j, the JSON of FILE
    [ "$(sqlite3 :memory: "with r as (select readfile('$1') as j) select $2 from r")" = 1 ]
}
value() { # FILE PATH: a value of it, as SQLite reads JSON.
    sqlite3 :memory: "select json_extract(readfile('$1'), '\$.$2')"
}
play() { "$ctl" play --round-s 10 "$@"; }

# ---- JSON
play --bot novice --mode festival --rounds 3 --seed 7 --json --record "$work/rec" >"$work/a.json" 2>"$work/err"
keys_are() { # PATH KEYS
    local found
    found=$(sqlite3 :memory: "select group_concat(key, ' ') from json_each(readfile('$work/a.json'), '$1')")
    [ "$found" = "$2" ] || { echo "$found"; return 1; }
}
check 'the JSON is valid' holds "$work/a.json" 'json_valid(j)'
check 'and has the keys that were promised, in their order' keys_are '$' 'rounds caught_median caught_p90 caught_max'
check 'and so has each round' keys_are '$.rounds[2]' 'caught scoops fouls torn_at_s sheets hole_area_mm2 state_hash'
check 'there are as many rounds as were asked for' holds "$work/a.json" "json_array_length(j,'\$.rounds')=3"
check 'numbers are numbers, and hashes 16 digits' holds "$work/a.json" \
    "(select count(*) from json_each(j,'\$.rounds') r where json_type(r.value,'\$.caught')='integer'
      and json_type(r.value,'\$.scoops')='integer' and json_type(r.value,'\$.fouls')='integer'
      and json_type(r.value,'\$.torn_at_s') in ('null','real') and json_type(r.value,'\$.hole_area_mm2')='integer'
      and json_extract(r.value,'\$.sheets')=1 and length(json_extract(r.value,'\$.state_hash'))=16)=3"
check 'the figures of all are those of the rounds' holds "$work/a.json" \
    "(select max(json_extract(value,'\$.caught')) from json_each(j,'\$.rounds'))=json_extract(j,'\$.caught_max')
     and json_extract(j,'\$.caught_median')=(select json_extract(value,'\$.caught') from json_each(j,'\$.rounds')
     order by 1 limit 1 offset 1) and json_extract(j,'\$.caught_p90')<=json_extract(j,'\$.caught_max')
     and json_extract(j,'\$.caught_p90')>=json_extract(j,'\$.caught_median')"
check 'nothing is told on standard error that nobody watches' test ! -s "$work/err"

# ---- The same again
play --bot novice --rounds 3 --seed 7 --json >"$work/b.json"
check 'the same seed plays the same rounds, recorded or not' cmp "$work/a.json" "$work/b.json"
play --bot novice --rounds 3 --seed 7 --json --jobs 1 >"$work/b.json"
check 'one after the other as side by side' cmp "$work/a.json" "$work/b.json"
play --bot novice --seed 8 --json >"$work/b.json"
same_hash() { # FILE INDEX FILE INDEX
    local one other
    one=$(value "$1" "rounds[$2].state_hash") other=$(value "$3" "rounds[$4].state_hash")
    echo "$one $other"
    [ -n "$one" ] && [ "$one" = "$other" ]
}
other_hash() { ! same_hash "$@" && [ -n "$(value "$3" "rounds[$4].state_hash")" ]; }
check 'the second round is the first of the next seed' same_hash "$work/a.json" 1 "$work/b.json" 0
check 'and no other' other_hash "$work/a.json" 0 "$work/b.json" 0
has_effect() { # OPTIONS...: they change how the first round ends.
    play --bot novice --seed 7 --json "$@" >"$work/b.json" && other_hash "$work/a.json" 0 "$work/b.json" 0
}
for options in '--bot expert' '--grade 7' '--mode practice' '--mode championship' '--fish 50' '--round-s 11'; do
    # shellcheck disable=SC2086
    check "$options has its effect" has_effect $options
done
check 'grade 6 is the default of the festival' \
    eval 'play --bot novice --seed 7 --grade 6 --json >"$work/b.json"; same_hash "$work/a.json" 0 "$work/b.json" 0'
play --bot novice --mode championship --seed 7 --json >"$work/c.json"
check 'grade 5 is that of the championship' \
    eval 'play --bot novice --mode championship --seed 7 --grade 5 --json >"$work/b.json"; same_hash "$work/c.json" 0 "$work/b.json" 0'

# ---- Recordings
check 'each round is a recording' eval '[ "$(cd "$work/rec" && echo *)" = "round-00001.kgr round-00002.kgr round-00003.kgr" ]'
for i in 1 2 3; do
    check "recording $i is true, to the hash that was told" eval \
        "'$ctl' replay verify '$work/rec/round-0000$i.kgr' | grep -F \"\$(value '$work/a.json' 'rounds[$((i - 1))].state_hash')\""
done

play --bot expert --mode championship --grade 7 --json --record "$work/won" >"$work/c.json"
"$ctl" replay info --json "$work/won/round-00001.kgr" >"$work/info.json"
check 'a recording tells who played what, and with what paper' holds "$work/info.json" \
    "json_extract(j,'\$.modes')=json('[{\"mode\":\"championship\",\"grade\":7}]') and json_extract(j,'\$.players')=1
     and json_extract(j,'\$.rounds')=1"
check 'and what came of it' eval '[ "$(value "$work/info.json" caught) $(value "$work/info.json" fouls) $(value "$work/info.json" hash)" = \
    "$(value "$work/c.json" "rounds[0].caught") $(value "$work/c.json" "rounds[0].fouls") $(value "$work/c.json" "rounds[0].state_hash")" ]'
check 'for people too' eval '"$ctl" replay info "$work/won/round-00001.kgr" | grep -q "championship with No. 7 paper"'

# ---- Bots from files
printf 'base=novice\n' >"$work/novice.bot"
play --bot "$work/novice.bot" --rounds 3 --seed 7 --json >"$work/b.json"
check 'a file that says novice plays as novice' cmp "$work/a.json" "$work/b.json"
printf '# slower\nbase=novice\narm_m_s = 0.31 # of 2\n' >"$work/slow.bot"
check 'one key more plays otherwise' has_effect --bot "$work/slow.bot"
for bot in "$here"/../bench/technique/*.bot; do
    check "$(basename "$bot") can be played" play --bot "$bot" --fish 20
done

# ---- For people
play --rounds 2 >"$work/text"
check 'people get a line a round and a summary' eval \
    '[ "$(grep -c "^round [12] .*caught.*scoops.*fouls.*hash" "$work/text")" = 2 ] && grep -q "^caught: median .*, p90 .*, most " "$work/text" &&
     [ "$(wc -l <"$work/text")" = 3 ]'
check 'and the help says how long a round may be beyond its seconds' eval \
    '"$ctl" play --help | tr -s " \n" "  " | grep -q "Fish on the paper at the end may still be brought to the bowl, 3 s at most"'
check 'the help tells every key of a bot' eval \
    '"$ctl" play --help >"$work/help"; for key in base wet entry_deg glide_deg side place lift hunt fish_max fish_m arm_m_s dip_m_s glide_m_s lift_m_s \
     carry_m_s drain_s patience_s aim_m tremor_m reaction_min_s reaction_max_s; do grep -qw -- "$key" "$work/help" || { echo $key; exit 1; }; done'
check 'and every option' eval \
    'for option in bot mode grade rounds seed fish round-s jobs record json; do grep -q -- "--$option " "$work/help" || { echo $option; exit 1; }; done'

# ---- Mistakes: one line that names what is wrong, nothing on standard output
mistake() { # STATUS NEEDLE OPTIONS...
    local expected=$1 needle=$2 status
    shift 2
    "$ctl" play "$@" >"$work/out" 2>"$work/err"
    status=$?
    cat "$work/err"
    echo "exit $status"
    [ $status -eq "$expected" ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] &&
        grep -qF -- "$needle" "$work/err"
}
bad_bot() { # NEEDLE TEXT: a bot file that is refused
    printf '%b' "$2" >"$work/bad.bot"
    mistake 65 "$work/bad.bot$1" --bot "$work/bad.bot"
}
check 'a bot that is not there is told' mistake 74 "$work/none.bot" --bot "$work/none.bot"
check 'and what a bot can be' mistake 74 'experrt: No such file or directory; novice, expert or a FILE is a bot' \
    --bot experrt
check 'a folder is no bot' mistake 74 "$work" --bot "$work"
check 'a misspelt key is named with its line' bad_bot ":3: 'wett'" 'base=novice\n\nwett=0.5\n'
check 'a value out of its range, with what is right' bad_bot ":1: wet: '1.5' is not right; 0 to 1 is" 'wet=1.5\n'
check 'a word that is none' bad_bot ":2: side: 'left' is not right; any|head|tail is" '#\nside=left\n'
check 'a key twice, with where it was' bad_bot ':2: wet is in line 1' 'wet=1\nwet=1\n'
check 'a base behind other keys' bad_bot ':2: base comes before' 'wet=1\nbase=novice\n'
check 'a line without a value' bad_bot ":1: 'wet' has no '='" 'wet\n'
check 'an empty bot' bad_bot ': has no key' ''
check 'a bot of bytes' bad_bot ':1: is no text' '\0\01\02'
check 'a mode that is none' mistake 2 "--mode: 'lab'" --mode lab
check 'a grade that no mill makes' mistake 2 '--grade' --grade 3
check 'no rounds' mistake 2 '--rounds' --rounds 0
check 'more fish than the water holds' mistake 2 '1 to ' --fish 2000
check 'a value that is missing' mistake 2 '--seed needs a value' --seed
check 'an option that is none' mistake 2 --fishes --fishes 3
check 'a round of no length' mistake 2 '--round-s' --round-s 9
check 'a folder that cannot be made' mistake 74 '/dev/null/rec' --record /dev/null/rec
recorded_twice() {
    play --bot novice --json --record "$work/rec" >"$work/out" 2>"$work/err"
    [ $? -eq 74 ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && grep -qF "$work/rec/round-00001.kgr" "$work/err"
}
check 'a recording that is there already is not written over' recorded_twice
full_output() {
    play --json >/dev/full
    [ $? -eq 74 ]
}
check 'a full disk where the figures go is told' full_output
echo "1..$count"
