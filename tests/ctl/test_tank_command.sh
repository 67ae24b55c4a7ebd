#!/bin/bash
# test_tank_command.sh -- `kingyoctl tank` as its users see it: JSON that another program reads, a trace
# that another program judges, the same again for the same seed, one line for each mistake. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
judge=$build/tests/ctl/judge_trace
json() { # FILE PATH: a value of it, as SQLite reads JSON.
    sqlite3 :memory: "select json_extract(readfile('$1'), '\$.$2')"
}
holds() { # SQL expression over j, the JSON of FILE
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
check 'and has the keys that were promised, in their order' has_keys
check 'a run of 5 s is 600 ticks of 300 fish' holds "$work/a.json" \
    "json_extract(j,'\$.ticks')=600 and json_extract(j,'\$.fish')=300 and json_extract(j,'\$.seed')=7"
check 'counts per second begin with the start' holds "$work/a.json" \
    "json_array_length(j,'\$.shade_count')=6 and json_array_length(j,'\$.surfacing_count')=6"
check 'gait shares sum to one' holds "$work/a.json" \
    "abs((select sum(value) from json_each(j,'\$.gait_share'))-1)<1e-5
     and json_array_length(j,'\$.gait_share') is not null"
check 'encounters, speeds and oxygen have their parts' holds "$work/a.json" \
    "json_extract(j,'\$.encounters.by_yaw')>0 and json_extract(j,'\$.encounters.by_pitch')>=0
     and json_extract(j,'\$.encounters.head_on')+json_extract(j,'\$.encounters.side')+
     json_extract(j,'\$.encounters.rear_end')>0 and json_extract(j,'\$.speed_cm_s.max')>
     json_extract(j,'\$.speed_cm_s.mean') and json_extract(j,'\$.oxygen_mg_l.start')>8"
check 'times are told' holds "$work/a.json" \
    "json_extract(j,'\$.ns_per_fish_tick')>1 and json_extract(j,'\$.tick_ms_median')>0
     and json_extract(j,'\$.tick_ms_p99')>=json_extract(j,'\$.tick_ms_median')"

# ---- Trace
judged() { # TRACE SIZE... PATTERN
    local said
    said=$("$judge" "$1" "$2" "$3" "$4") || return 1
    echo "$said"
    grep -qE "$5" <<<"$said"
}
no_deep() { # TRACE SIZE...: nothing deeper than 0.5 mm, nothing beyond a wall by 0.1 mm.
    "$judge" "$1" "$2" "$3" "$4" | awk '{ print; exit !($10 == 0 && $12 <= 0.5 && $14 <= 0.1) }'
}
"$ctl" tank --preset official --seconds 3 --json --trace "$work/official.csv" --trace-every 60 >/dev/null
check 'the trace has a row of each fish each 12 ticks' judged "$work/trace.csv" 136 20 65 \
    '^rows 15300 ticks 51 fish 300 last 600 '
check 'no bodies in each other, by a judge that shares no code' no_deep "$work/trace.csv" 136 20 65
check 'nor in the championship' no_deep "$work/official.csv" 136 10 65
# A trace with one fish moved into another must be found out: the judge can fail.
awk -F, -v OFS=, '$1 == 0 && $2 == 0 { x = $3; y = $4; z = $5 } $1 == 0 && $2 == 1 { $3 = x + 0.3; $4 = y; $5 = z } 1' \
    "$work/trace.csv" >"$work/moved.csv"
check 'and the judge sees two fish in one place' judged "$work/moved.csv" 136 20 65 'overlaps [1-9]'

# ---- Counts
"$ctl" tank --fish 200 --seconds 10 --shade 0,0,10,0,10 --json --trace "$work/shade.csv" --trace-every 120 >"$work/shade.json"
check 'a still shadow gathers fish (figures 4.17 to 4.20)' holds "$work/shade.json" \
    "json_extract(j,'\$.shade_count[10]')>=2*json_extract(j,'\$.shade_count[0]')"
from_trace() { # The fish within 10 cm of the middle, second by second, as the trace has them.
    awk -F, 'NR > 1 { seen[$1 / 120] += $3 * $3 + $5 * $5 <= 100 }
        END { for (s = 0; s <= 10; s++) printf "%s%d", s ? "," : "", seen[s]; print "" }' "$work/shade.csv"
}
equal_counts() {
    from_trace
    json "$work/shade.json" shade_count
    [ "$(from_trace)" = "$(json "$work/shade.json" shade_count | tr -d '[] ')" ]
}
check 'and as many as the trace shows' equal_counts
"$ctl" tank --fish 60 --stamina 20 --seconds 4 --json --trace "$work/gulp.csv" --trace-every 480 >"$work/gulp.json"
gulpers() {
    local seen
    seen=$(awk -F, '$1 == 480 && $14 == "surface"' "$work/gulp.csv" | wc -l)
    echo "$seen"
    [ "$seen" -gt 0 ] && [ "$(json "$work/gulp.json" 'surfacing_count[4]')" = "$seen" ]
}
check 'tired fish come to the surface, as many as the trace shows' gulpers

# ---- The same again
hash_of() { "$ctl" tank "$@" --json >"$work/h.json" && json "$work/h.json" state_hash; }
same() { [ "$1" = "$2" ] && [ -n "$1" ]; }
differ() { [ "$1" != "$2" ] && [ -n "$1" ]; }
first=$(hash_of --fish 300 --seconds 3 --seed 5)
check 'observations change nothing in the tank' same "$first" "$(hash_of --fish 300 --seconds 3 --seed 5 --observe-every 50)"
check 'and every 50th tick with the last one are observed' holds "$work/h.json" \
    "json_extract(j,'\$.observe_every')=50 and abs((select sum(value) from json_each(j,'\$.gait_share'))-1)<1e-5"
check 'the same seed swims to the same hash' same "$first" "$(hash_of --fish 300 --seconds 3 --seed 5)"
check 'all pairs find what the grid finds' same "$first" \
    "$(hash_of --fish 300 --seconds 3 --seed 5 --pairs all)"
check 'another seed does not' differ "$first" "$(hash_of --fish 300 --seconds 3 --seed 6)"
for option in '--temperature-c 8' '--pressure-hpa 900' '--oxygen-mg-l 3' '--time-compression 200' '--stamina 50' \
    '--area-scale 0.9' '--size-cm 100,20,60' '--wall-follow 1' '--spaces ball' '--shade 0,0,20,0,3' '--preset festival' '--pump on'; do
    # shellcheck disable=SC2086
    check "$option has its effect" differ "$first" "$(hash_of --fish 300 --seconds 3 --seed 5 $option)"
done

# ---- Many fish
# The hashes were recorded when the command had room for 2,048 fish.
while read -r recorded options; do
    # shellcheck disable=SC2086
    check "$options swims to the hash that was recorded" same "$recorded" "$(hash_of --seconds 3 --seed 5 $options)"
done <<'END'
79d6e21075ce3597 --preset official --fish 2048
2da1629f35d80c74 --fish 600 --area-scale 5
93169fcd3d7ee63e --preset festival --fish 613
ec7579c5028b65b0 --fish 100 --area-scale 200
END
"$ctl" tank --fish 131072 --area-scale 250 --seconds 0.1 --json >"$work/many.json"
check '131,072 fish swim' holds "$work/many.json" "json_extract(j,'\$.fish')=131072"
check 'without touching' holds "$work/many.json" "json_extract(j,'\$.body_overlaps')=0"
check 'and are observed every 24th tick' holds "$work/many.json" "json_extract(j,'\$.observe_every')=24"
too_many() { "$ctl" tank --fish 131073 --area-scale 250 2>"$work/text"; [ $? -eq 2 ] && grep -q '1 to 131072 fish' "$work/text"; }
check '131,073 fish are refused with the limit' too_many

# ---- Files
printf 't_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg\n0,-50,-8,0,0,0,0\n3,50,-8,0,0,20,0\n' >"$work/path.csv"
printf 'x_cm,y_cm,z_cm,yaw_deg,speed_cm_s,gait\n-12,-10,0.2,-90,5.25,swim\n12,-10,0,90,5.25,swim\n' >"$work/place.csv"
check 'a poi that is led through has its effect' differ "$first" \
    "$(hash_of --fish 300 --seconds 3 --seed 5 --poi-path "$work/path.csv")"
"$ctl" tank --place "$work/place.csv" --seconds 4 --json --trace "$work/two.csv" --trace-every 1 >"$work/two.json"
check 'two placed fish meet head-on' holds "$work/two.json" \
    "json_extract(j,'\$.encounters.head_on')>=1 and json_extract(j,'\$.encounters.side')=0"
check 'and begin where they were placed' grep -q '^0,0,-12.0000,-10.0000,0.2000,-90.0000,' "$work/two.csv"
check 'without touching' no_deep "$work/two.csv" 136 20 65
"$ctl" tank --fish 20 --seconds 1 --trace "$work/every.csv" --trace-every 30 >"$work/text"
check 'figures for people, too' grep -q 'ns a fish and tick' "$work/text"
check 'a trace can be placed again' "$ctl" tank --place "$work/every.csv" --seconds 1
placed_alike() { # TRACE PRESET: the fish of its only tick stand where they stood, but for rounding.
    "$ctl" tank --preset "$2" --place "$1" --seconds 0.1 --trace "$work/alike.csv" >"$work/text" || return 1
    awk -F, 'FNR == 1 { next } NR == FNR { for (k = 2; k <= 11; k++) was[FNR, k] = $k; rows++; next }
        $1 == 0 { seen++; for (k = 2; k <= 11; k++) if (($k - was[FNR, k]) ^ 2 > 0.0003 ^ 2) { print; bad = 1 } }
        END { print seen, "of", rows; exit bad || seen != rows || seen < 100 }' "$1" "$work/alike.csv"
}
# Of fish that fled from a poi in bad water, the last tick: all gaits there are, but for those on the poi.
printf 't_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg\n0,-30,6,0,0,0,0\n1.5,-30,-5,0,0,0,0\n3,30,-5,0,0,0,0\n' >"$work/flee.csv"
"$ctl" tank --preset festival --oxygen-mg-l 1 --seconds 2.4 --poi-path "$work/flee.csv" --trace "$work/fled.csv" \
    --trace-every 288 >/dev/null
awk -F, 'NR == 1 || $1 == 288 && $14 != "held"' "$work/fled.csv" >"$work/last.csv"
has_gaits() { for gait in escape surface; do grep -c ",$gait," "$work/last.csv" || return 1; done; }
check 'and one of fish that flee and gulp' has_gaits
check 'each where it was' placed_alike "$work/last.csv" festival

# A poi lifts fish and carries them off faster than they swim: their speed is not the shoal's.
printf '%s\n' t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg 0,-30,6,0,0,0,0 0.5,-30,-7,0,0,40,0 1.5,-10,-7,0,0,10,0 \
    3,0,5,0,0,0,0 3.3,40,5,0,0,0,0 >"$work/lift.csv"
"$ctl" tank --preset official --oxygen-mg-l 1 --seconds 3.5 --poi-path "$work/lift.csv" --json --trace "$work/lift.trace" \
    --trace-every 1 >"$work/lift.json"
swim_speeds() { # Mean and greatest, of who is not held; of who is, how many there were.
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
check 'speeds are of fish that swim, not of those on the poi' equal_speeds

# ---- Mistakes: one line that names the option, nothing on standard output
mistake() { # STATUS NEEDLE OPTIONS...
    local expected=$1 needle=$2 status
    shift 2
    "$ctl" tank "$@" >"$work/out" 2>"$work/err"
    status=$?
    cat "$work/err"
    echo "exit $status"
    [ $status -eq "$expected" ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] &&
        grep -qF -- "$needle" "$work/err"
}
check 'too many fish name the range' mistake 2 '1 to ' --fish 100000
check 'as many fish as were placed' mistake 2 '--fish' --fish 3 --place "$work/place.csv"
check 'a word is no number' mistake 2 --seconds --seconds soon
check 'nor is NaN' mistake 2 --temperature-c --temperature-c nan
check 'an unknown option is wrong usage' mistake 2 --fishes --fishes 3
check 'a folder that is not there is told' mistake 74 /nowhere/ --seconds 1 --trace /nowhere/t.csv
check 'a file that is not there, too' mistake 74 "$work/none" --place "$work/none"
sed 's/-8,0,0,20/-8,0,0,inf/' "$work/path.csv" >"$work/bad.csv"
check 'an infinite angle is bad data, by line and column' mistake 65 'line 3, column 6 (pitch_deg)' \
    --poi-path "$work/bad.csv"
sed 's/5.25,swim/5.25,fly/' "$work/place.csv" >"$work/bad.csv"
check 'and so is a gait that is none' mistake 65 'line 2, column 6 (gait)' --place "$work/bad.csv"
printf '%s\n' 'x_cm,y_cm,z_cm,yaw_deg,stamnia' '0,-5,0,0,50' >"$work/bad.csv"
check 'a misspelt column is no default' mistake 65 "line 1, column 5: 'stamnia'" --place "$work/bad.csv"
sed 's/^3,.*/&,9/' "$work/path.csv" >"$work/bad.csv"
check 'nor are surplus fields passed over' mistake 65 "line 3, column 8: '9'" --poi-path "$work/bad.csv"
check 'a full disk is told' mistake 74 /dev/full --seconds 1 --trace /dev/full
full_output() {
    "$ctl" tank --fish 5 --seconds 1 --json >/dev/full
    [ $? -eq 74 ]
}
check 'where the figures go, too' full_output
check 'a folder is no file' mistake 74 "$work" --place "$work"
printf 'x_cm,y_cm,z_cm,yaw_deg\n0,-5,0,0\n0,-5,4.9,0\n' >"$work/bad.csv"
check 'fish in each other cannot be placed' mistake 65 'fish 0 and 1' --place "$work/bad.csv"
echo "1..$count"
