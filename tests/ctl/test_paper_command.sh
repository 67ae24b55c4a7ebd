#!/bin/bash
# test_paper_command.sh -- `kingyoctl paper`: its figures against measured or calculated values,
# some of them found by bisection, and one line for each mistake. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
holds() { # SQL expression over j, the JSON that the command prints
    local sql=$1
    shift
    "$ctl" paper "$@" --json >"$work/j.json" || return 1
    cat "$work/j.json"
    [ "$(sqlite3 :memory: "with r as (select readfile('$work/j.json') as j) select $sql from r")" = 1 ]
}
get() { echo "json_extract(j,'\$.$1')"; }

# ---- Output
keys='force_n,tension_n_m_max,time_to_tear_s,hole_area_mm2,water_g'
check 'the JSON has the documented keys in their order' holds \
    "json_valid(j) and (select group_concat(key) from json_each(j))='$keys'" --grade 6 --wetness 1 \
    --wet-fraction 1 --tilt-deg 90 --speed-m-s 0.3 --medium water --seconds 1 --seed 3
check 'paper that does not tear has no time and no hole' holds "$(get time_to_tear_s) is null and $(get hole_area_mm2)=0" \
    --speed-m-s 0.1
check 'paper that tears has a time and a hole' holds "$(get time_to_tear_s)<=0.05 and $(get hole_area_mm2)>100" \
    --grade 7 --speed-m-s 1 --seconds 0.5
check 'the hole is not larger than the paper' holds "abs($(get hole_area_mm2)-5026.55)<0.01" --grade 6 \
    --speed-m-s 0.8
text() { # PATTERN OPTIONS...: A line of the text output matches PATTERN.
    local pattern=$1
    shift
    "$ctl" paper "$@" | tee "$work/text"
    grep -qE "$pattern" "$work/text"
}
check 'the text reports an immediate tear' text 'tears after .* instant' --grade 7 --speed-m-s 1
check 'the text reports a tear after some seconds' text 'tears after +[0-9.]+ s$' --grade 7 --speed-m-s 0.42 --seconds 60
check 'the text reports paper that does not tear' text 'tears +not in 2 s' --grade 4 --speed-m-s 0.3 --seconds 2
check '--help prints examples' text '^  kingyoctl paper --grade 6' --help

# ---- Figures
check 'the force broadside at 0.3 m/s is 0.25 N within 10 %' holds "abs($(get force_n)-0.25)<0.025" \
    --grade 5 --tilt-deg 90 --speed-m-s 0.3
check 'the force edge-on is below 0.01 N' holds "$(get force_n)>0 and $(get force_n)<0.01" \
    --grade 5 --tilt-deg 0 --speed-m-s 0.3
check 'the upside-down poi holds 15 g of water within 10 %' holds "abs($(get water_g)-15)<1.5" \
    --medium air --upside-down --seconds 1
check 'the upright poi in air holds 1 to 4 g of water' holds "$(get water_g)<4 and $(get water_g)>1" --medium air --seconds 1
for grade in 4 5 6 7; do
    check "No. $grade: a still fish of 5 cm in air does not tear the paper in 60 s" holds \
        "$(get time_to_tear_s) is null and $(get hole_area_mm2)=0 and $(get force_n)>0.02" --grade $grade \
        --medium air --fish 1 --fish-cm 5 --still --seconds 60
done
instant() { # OPTIONS...: Prints the lowest speed, in mm/s, at which the paper tears within 0.05 s.
    local low=50 high=4000 middle
    while [ $((high - low)) -gt 2 ]; do
        middle=$(((low + high) / 2))
        if "$ctl" paper "$@" --seconds 0.06 --speed-m-s "$(printf '%d.%03d' $((middle / 1000)) $((middle % 1000)))" \
            | grep -q ': instant$'; then high=$middle; else low=$middle; fi
    done
    echo "$high"
}
within() { # PER CENT GOT EXPECTED: GOT differs from EXPECTED by at most PER CENT.
    echo "$2, expected $3 within $1 %"
    [ $((100 * ($2 - $3))) -le $(($1 * $3)) ] && [ $((100 * ($3 - $2))) -le $(($1 * $3)) ]
}
# 0.423 (Y p^2 a^2)^(1/3) = T with a = 0.04 m, and p = 1.12 rho v^2 / 2.
formula() { # T Y: mm/s
    awk -v t="$1" -v y="$2" 'BEGIN { p = (t / 0.423) ^ 1.5 / sqrt(y) / 0.04; print int(1000 * sqrt(2 * p / 1120)) }'
}
while read -r grade strength stiffness; do
    check "No. $grade tears at the speed of the membrane formula within 15 %" within 15 \
        "$(instant --grade "$grade" --ideal)" "$(formula "$strength" "$stiffness")"
    check "No. $grade tears at half the speed when half of it is wet, within 15 %" within 15 \
        "$(instant --grade "$grade" --wet-fraction 0.5)" "$(($(instant --grade "$grade") / 2))"
done <<'GRADES'
4 60 2800
5 45 2300
6 32 2000
7 20 1600
GRADES
same() { [ "$("$ctl" paper --json "$@" --seed 7)" = "$("$ctl" paper --json "$@" --seed 7)" ]; }
differ() { [ "$("$ctl" paper --json "$@" --seed 7)" != "$("$ctl" paper --json "$@" --seed 8)" ]; }
check 'the same seed gives the same tear' same --grade 7 --speed-m-s 0.4 --seconds 20
check 'another seed gives another tear' differ --grade 7 --speed-m-s 0.4 --seconds 20
check 'slapping fish strain the paper more than still fish' holds "$(get tension_n_m_max)>7" \
    --medium air --fish 3 --seconds 5
check 'fish in water do not load the paper' holds "$(get tension_n_m_max)<0.1" --medium water --fish 3 --seconds 1

# ---- Calibration by weights
check '--calibrate prints a line of the table of grades' text '\.wet_n_m = 4[0-9]\.[0-9]f' --grade 5 \
    --calibrate 66,78,70,62,74 --footprint-mm 20 --hang-s 5
check 'twice the weight on a foot gives a stronger paper' holds "$(get wet_n_m)>70 and $(get specimens)=2" --grade 5 \
    --calibrate 132,156
check 'a longer hanging time gives a stronger paper' holds "$(get wet_n_m)>55" --grade 5 --calibrate 70 --hang-s 60

# ---- Mistakes: one line that names the option, nothing on standard output
mistake() { # STATUS NEEDLE OPTIONS...: Exits with STATUS and one error line that contains NEEDLE.
    local expected=$1 needle=$2 status
    shift 2
    "$ctl" paper "$@" >"$work/out" 2>"$work/err"
    status=$?
    cat "$work/err"
    echo "exit $status"
    [ $status -eq "$expected" ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] &&
        grep -qF -- "$needle" "$work/err"
}
check 'an unknown grade is wrong usage' mistake 2 'from 4 to 7' --grade 3
check 'a fractional grade is wrong usage' mistake 2 'a whole number' --grade 4.5
check 'a wetness above 1 is wrong usage' mistake 2 --wetness --wetness 1.1
check 'a negative fraction is wrong usage' mistake 2 --wet-fraction --wet-fraction -0.1
check 'a tilt above 90 degrees is wrong usage' mistake 2 'from 0 to 90' --tilt-deg 91
check 'a speed of 50 m/s is wrong usage' mistake 2 --speed-m-s --speed-m-s 50
check 'text in place of a number is wrong usage' mistake 2 --seconds --seconds soon
check 'NaN is wrong usage' mistake 2 --speed-m-s --speed-m-s nan
check 'a missing value is wrong usage' mistake 2 --fish --fish
check 'an unknown medium is wrong usage' mistake 2 'water or air' --medium oil
check 'more than 16 fish are wrong usage' mistake 2 'from 0 to 16' --fish 17
check 'an empty weight is wrong usage' mistake 2 --calibrate --calibrate 70,,60
check 'an unknown option is wrong usage' mistake 2 --sped --sped 1
full_output() {
    "$ctl" paper --json >/dev/full
    [ $? -eq 74 ]
}
check 'a full standard output exits with 74' full_output
echo "1..$count"
