#!/bin/bash
# test_tank_command.sh -- `kingyoctl tank`: valid JSON, a trace that an independent program
# (check_trace) checks, the same result for the same seed, one line for each mistake. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
check_trace=$build/tests/ctl/check_trace
json() { # FILE PATH: Prints one value of FILE, which SQLite parses.
    sqlite3 :memory: "select json_extract(readfile('$1'), '\$.$2')"
}
holds() { # FILE EXPRESSION: The SQL expression over j, the JSON of FILE, is true.
    [ "$(sqlite3 :memory: "with r as (select readfile('$1') as j) select $2 from r")" = 1 ]
}

# ---- JSON
"$ctl" tank --fish 300 --seconds 5 --seed 7 --shade 0,0,10,1,4 --json --trace "$work/trace.csv" >"$work/a.json"
keys='preset fish seconds seed ticks observe_every state_hash ns_per_fish_tick tick_ms_median tick_ms_p99 body_overlaps
deepest_overlap_mm encounters gait_share speed_cm_s stamina_mean surfacing_share oxygen_mg_l shade_count
surfacing_count'
has_keys() {
    local found
    found=$(sqlite3 :memory: "select group_concat(key, ' ') from json_each(readfile('$work/a.json'))")
    [ "$found" = "$(tr '\n' ' ' <<<"$keys" | sed 's/ $//')" ] || { echo "$found"; return 1; }
}
check 'the JSON is valid' holds "$work/a.json" 'json_valid(j)'
check 'the JSON has the documented keys in their order' has_keys
check 'a simulation of 5 s has 600 ticks of 300 fish' holds "$work/a.json" \
    "json_extract(j,'\$.ticks')=600 and json_extract(j,'\$.fish')=300 and json_extract(j,'\$.seed')=7"
check 'the counts per second include second 0' holds "$work/a.json" \
    "json_array_length(j,'\$.shade_count')=6 and json_array_length(j,'\$.surfacing_count')=6"
check 'the gait shares sum to 1' holds "$work/a.json" \
    "abs((select sum(value) from json_each(j,'\$.gait_share'))-1)<1e-5
     and json_array_length(j,'\$.gait_share') is not null"
check 'encounters, speeds and oxygen have plausible values' holds "$work/a.json" \
    "json_extract(j,'\$.encounters.by_yaw')>0 and json_extract(j,'\$.encounters.by_pitch')>=0
     and json_extract(j,'\$.encounters.head_on')+json_extract(j,'\$.encounters.side')+
     json_extract(j,'\$.encounters.rear_end')>0 and json_extract(j,'\$.speed_cm_s.max')>
     json_extract(j,'\$.speed_cm_s.mean') and json_extract(j,'\$.oxygen_mg_l.start')>8"
check 'the times are measured' holds "$work/a.json" \
    "json_extract(j,'\$.ns_per_fish_tick')>1 and json_extract(j,'\$.tick_ms_median')>0
     and json_extract(j,'\$.tick_ms_p99')>=json_extract(j,'\$.tick_ms_median')"

# ---- Trace
check_trace_prints() { # TRACE SIZE... PATTERN: The output of check_trace on TRACE matches PATTERN.
    local printed
    printed=$("$check_trace" "$1" "$2" "$3" "$4") || return 1
    echo "$printed"
    grep -qE "$5" <<<"$printed"
}
# TRACE SIZE...: No overlap is deeper than 0.5 mm, and no body is more than 0.1 mm outside a wall.
no_deep() {
    "$check_trace" "$1" "$2" "$3" "$4" | awk '{ print; exit !($10 == 0 && $12 <= 0.5 && $14 <= 0.1) }'
}
"$ctl" tank --preset official --seconds 3 --json --trace "$work/official.csv" --trace-every 60 >/dev/null
check 'the trace has one row for each fish every 12 ticks' check_trace_prints "$work/trace.csv" 136 20 65 \
    '^rows 15300 ticks 51 fish 300 last 600 '
check 'the independent check of the festival trace finds no overlap' no_deep "$work/trace.csv" 136 20 65
check 'the independent check of the championship trace finds no overlap' no_deep "$work/official.csv" 136 10 65
# The independent check must detect an overlap in a trace in which one fish was moved into another.
awk -F, -v OFS=, '$1 == 0 && $2 == 0 { x = $3; y = $4; z = $5 } $1 == 0 && $2 == 1 { $3 = x + 0.3; $4 = y; $5 = z } 1' \
    "$work/trace.csv" >"$work/moved.csv"
check 'the independent check detects two fish in one place' check_trace_prints "$work/moved.csv" 136 20 65 'overlaps [1-9]'

# ---- Counts
"$ctl" tank --fish 200 --seconds 10 --shade 0,0,10,0,10 --json --trace "$work/shade.csv" --trace-every 120 >"$work/shade.json"
check 'a still shadow attracts fish (figures 4.17 to 4.20)' holds "$work/shade.json" \
    "json_extract(j,'\$.shade_count[10]')>=2*json_extract(j,'\$.shade_count[0]')"
from_trace() { # Prints the number of fish within 10 cm of the centre for each second of the trace.
    awk -F, 'NR > 1 { seen[$1 / 120] += $3 * $3 + $5 * $5 <= 100 }
        END { for (s = 0; s <= 10; s++) printf "%s%d", s ? "," : "", seen[s]; print "" }' "$work/shade.csv"
}
equal_counts() {
    from_trace
    json "$work/shade.json" shade_count
    [ "$(from_trace)" = "$(json "$work/shade.json" shade_count | tr -d '[] ')" ]
}
check 'the shade counts equal those of the trace' equal_counts
"$ctl" tank --fish 60 --stamina 20 --seconds 4 --json --trace "$work/gulp.csv" --trace-every 480 >"$work/gulp.json"
gulpers() {
    local seen
    seen=$(awk -F, '$1 == 480 && $14 == "surface"' "$work/gulp.csv" | wc -l)
    echo "$seen"
    [ "$seen" -gt 0 ] && [ "$(json "$work/gulp.json" 'surfacing_count[4]')" = "$seen" ]
}
check 'exhausted fish surface, and their count equals that of the trace' gulpers

# ---- Determinism
hash_of() { "$ctl" tank "$@" --json >"$work/h.json" && json "$work/h.json" state_hash; }
same() { [ "$1" = "$2" ] && [ -n "$1" ]; }
differ() { [ "$1" != "$2" ] && [ -n "$1" ]; }
first=$(hash_of --fish 300 --seconds 3 --seed 5)
check '--observe-every does not change the simulation' same "$first" "$(hash_of --fish 300 --seconds 3 --seed 5 --observe-every 50)"
check 'every 50th tick and the last tick are observed' holds "$work/h.json" \
    "json_extract(j,'\$.observe_every')=50 and abs((select sum(value) from json_each(j,'\$.gait_share'))-1)<1e-5"
check 'the same seed gives the same hash' same "$first" "$(hash_of --fish 300 --seconds 3 --seed 5)"
check '--pairs all gives the same hash as the grid' same "$first" \
    "$(hash_of --fish 300 --seconds 3 --seed 5 --pairs all)"
check 'another seed gives another hash' differ "$first" "$(hash_of --fish 300 --seconds 3 --seed 6)"
for option in '--temperature-c 8' '--pressure-hpa 900' '--oxygen-mg-l 3' '--time-compression 200' '--stamina 50' \
    '--area-scale 0.9' '--size-cm 100,20,60' '--wall-follow 1' '--spaces ball' '--shade 0,0,20,0,3' '--preset festival' '--pump on'; do
    # shellcheck disable=SC2086
    check "$option changes the hash" differ "$first" "$(hash_of --fish 300 --seconds 3 --seed 5 $option)"
done

# ---- Many fish
# The hashes were recorded when the command was limited to 2,048 fish.
while read -r recorded options; do
    # shellcheck disable=SC2086
    check "$options gives the recorded hash" same "$recorded" "$(hash_of --seconds 3 --seed 5 $options)"
done <<'END'
79d6e21075ce3597 --preset official --fish 2048
2da1629f35d80c74 --fish 600 --area-scale 5
93169fcd3d7ee63e --preset festival --fish 613
ec7579c5028b65b0 --fish 100 --area-scale 200
END
"$ctl" tank --fish 131072 --area-scale 250 --seconds 0.1 --json >"$work/many.json"
check '131,072 fish can be simulated' holds "$work/many.json" "json_extract(j,'\$.fish')=131072"
check '131,072 fish do not overlap' holds "$work/many.json" "json_extract(j,'\$.body_overlaps')=0"
check '131,072 fish are observed every 24th tick' holds "$work/many.json" "json_extract(j,'\$.observe_every')=24"
too_many() { "$ctl" tank --fish 131073 --area-scale 250 2>"$work/text"; [ $? -eq 2 ] && grep -q '1 to 131072 fish' "$work/text"; }
check '131,073 fish are refused, and the error gives the limit' too_many

# ---- Files
printf 't_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg\n0,-50,-8,0,0,0,0\n3,50,-8,0,0,20,0\n' >"$work/path.csv"
printf 'x_cm,y_cm,z_cm,yaw_deg,speed_cm_s,gait\n-12,-10,0.2,-90,5.25,swim\n12,-10,0,90,5.25,swim\n' >"$work/place.csv"
check '--poi-path changes the hash' differ "$first" \
    "$(hash_of --fish 300 --seconds 3 --seed 5 --poi-path "$work/path.csv")"
"$ctl" tank --place "$work/place.csv" --seconds 4 --json --trace "$work/two.csv" --trace-every 1 >"$work/two.json"
check 'two placed fish meet head-on' holds "$work/two.json" \
    "json_extract(j,'\$.encounters.head_on')>=1 and json_extract(j,'\$.encounters.side')=0"
check 'the placed fish begin at their places' grep -q '^0,0,-12.0000,-10.0000,0.2000,-90.0000,' "$work/two.csv"
check 'the two placed fish do not overlap' no_deep "$work/two.csv" 136 20 65
"$ctl" tank --fish 20 --seconds 1 --trace "$work/every.csv" --trace-every 30 >"$work/text"
check 'the text prints the time per fish and tick' grep -q 'ns a fish and tick' "$work/text"
check 'a trace can be used as --place' "$ctl" tank --place "$work/every.csv" --seconds 1
# TRACE PRESET: The fish of the only tick have their places of TRACE, except for rounding.
placed_alike() {
    "$ctl" tank --preset "$2" --place "$1" --seconds 0.1 --trace "$work/alike.csv" >"$work/text" || return 1
    awk -F, 'FNR == 1 { next } NR == FNR { for (k = 2; k <= 11; k++) was[FNR, k] = $k; rows++; next }
        $1 == 0 { seen++; for (k = 2; k <= 11; k++) if (($k - was[FNR, k]) ^ 2 > 0.0003 ^ 2) { print; bad = 1 } }
        END { print seen, "of", rows; exit bad || seen != rows || seen < 100 }' "$1" "$work/alike.csv"
}
# The last tick of fish that flee from a poi in water with little oxygen. It contains all gaits
# except that of fish on the poi.
printf 't_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg\n0,-30,6,0,0,0,0\n1.5,-30,-5,0,0,0,0\n3,30,-5,0,0,0,0\n' >"$work/flee.csv"
"$ctl" tank --preset festival --oxygen-mg-l 1 --seconds 2.4 --poi-path "$work/flee.csv" --trace "$work/fled.csv" \
    --trace-every 288 >/dev/null
awk -F, 'NR == 1 || $1 == 288 && $14 != "held"' "$work/fled.csv" >"$work/last.csv"
has_gaits() { for gait in escape surface; do grep -c ",$gait," "$work/last.csv" || return 1; done; }
check 'the last tick contains fleeing and surfacing fish' has_gaits
check 'fish that are placed from a trace keep their places' placed_alike "$work/last.csv" festival

# A poi lifts fish and carries them faster than they swim. Their speed must not count as swimming
# speed.
printf '%s\n' t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg 0,-30,6,0,0,0,0 0.5,-30,-7,0,0,40,0 1.5,-10,-7,0,0,10,0 \
    3,0,5,0,0,0,0 3.3,40,5,0,0,0,0 >"$work/lift.csv"
"$ctl" tank --preset official --oxygen-mg-l 1 --seconds 3.5 --poi-path "$work/lift.csv" --json --trace "$work/lift.trace" \
    --trace-every 1 >"$work/lift.json"
# Prints the mean and the maximum speed of the fish that are not held, and the number of held fish.
swim_speeds() {
    awk -F, 'NR > 1 && $1 > 0 { if ($14 == "held") { held++; next } all++; sum += $12; top = $12 > top ? $12 : top }
        END { printf "%.4f %.4f %d\n", sum / all, top, held }' "$work/lift.trace"
}
equal_speeds() {
    local mean top held
    read -r mean top held < <(swim_speeds)
    echo "the trace: $mean $top, $held held; the figures: $(json "$work/lift.json" speed_cm_s)"
    [ "$held" -gt 100 ] && holds "$work/lift.json" \
        "abs(json_extract(j,'\$.speed_cm_s.mean')-$mean)<0.002 and abs(json_extract(j,'\$.speed_cm_s.max')-$top)<0.002"
}
check 'the speeds exclude the fish on the poi' equal_speeds

# ---- Mistakes: one line that names the option, nothing on standard output
mistake() { # STATUS NEEDLE OPTIONS...: Exits with STATUS and one error line that contains NEEDLE.
    local expected=$1 needle=$2 status
    shift 2
    "$ctl" tank "$@" >"$work/out" 2>"$work/err"
    status=$?
    cat "$work/err"
    echo "exit $status"
    [ $status -eq "$expected" ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] &&
        grep -qF -- "$needle" "$work/err"
}
check 'a number of fish outside its range is wrong usage' mistake 2 '1 to ' --fish 100000
check '--fish that differs from the number of placed fish is wrong usage' mistake 2 '--fish' --fish 3 --place "$work/place.csv"
check 'text in place of a number is wrong usage' mistake 2 --seconds --seconds soon
check 'NaN is wrong usage' mistake 2 --temperature-c --temperature-c nan
check 'an unknown option is wrong usage' mistake 2 --fishes --fishes 3
check 'a trace into a missing folder exits with 74' mistake 74 /nowhere/ --seconds 1 --trace /nowhere/t.csv
check 'a missing --place file exits with 74' mistake 74 "$work/none" --place "$work/none"
sed 's/-8,0,0,20/-8,0,0,inf/' "$work/path.csv" >"$work/bad.csv"
check 'an infinite angle exits with 65 and gives line and column' mistake 65 'line 3, column 6 (pitch_deg)' \
    --poi-path "$work/bad.csv"
sed 's/5.25,swim/5.25,fly/' "$work/place.csv" >"$work/bad.csv"
check 'an unknown gait exits with 65 and gives line and column' mistake 65 'line 2, column 6 (gait)' --place "$work/bad.csv"
printf '%s\n' 'x_cm,y_cm,z_cm,yaw_deg,stamnia' '0,-5,0,0,50' >"$work/bad.csv"
check 'a misspelt column exits with 65' mistake 65 "line 1, column 5: 'stamnia'" --place "$work/bad.csv"
sed 's/^3,.*/&,9/' "$work/path.csv" >"$work/bad.csv"
check 'a surplus field exits with 65' mistake 65 "line 3, column 8: '9'" --poi-path "$work/bad.csv"
check 'a trace to a full disk exits with 74' mistake 74 /dev/full --seconds 1 --trace /dev/full
full_output() {
    "$ctl" tank --fish 5 --seconds 1 --json >/dev/full
    [ $? -eq 74 ]
}
check 'a full standard output exits with 74' full_output
check 'a folder in place of a file exits with 74' mistake 74 "$work" --place "$work"
printf 'x_cm,y_cm,z_cm,yaw_deg\n0,-5,0,0\n0,-5,4.9,0\n' >"$work/bad.csv"
check 'fish that overlap cannot be placed' mistake 65 'fish 0 and 1' --place "$work/bad.csv"
echo "1..$count"
