#!/bin/bash
# fuzz_devices.sh FOLDER SECONDS TARGET... -- runs each target so long, and counts.
#
# FOLDER (build/fuzz) holds the programs, what they found worth keeping (corpus/TARGET), findings, a log each,
# and devices.tsv, to which every run adds a row: so that many runs have one sum. Exits 1 at a finding.
set -u
folder=$1 seconds=$2
shift 2
ledger=$folder/devices.tsv
mkdir -p "$folder/findings"
[ -s "$ledger" ] || printf 'commit\ttarget\tseconds\texecutions\tedges\tfindings\n' >"$ledger"
commit=$(git rev-parse --short HEAD 2>/dev/null || echo none)
worst=0

tests/fuzz/device_seeds.sh "$folder/seeds"
stat_of() { sed -n "s/^stat::$2: *//p" "$1" | tail -1; }

for target in "$@"; do
    log=$folder/$target.log
    seeds=
    for of in "tests/fuzz/corpus/$target" "$folder/seeds/$target"; do [ -d "$of" ] && seeds+=" $of"; done
    mkdir -p "$folder/corpus/$target"
    # shellcheck disable=SC2086
    nice "$folder/device_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=1024 -max_len=4096 \
        -close_fd_mask=1 -print_final_stats=1 -artifact_prefix="$folder/findings/$target-" "$folder/corpus/$target" \
        $seeds >"$log" 2>&1
    code=$?
    executions=$(stat_of "$log" number_of_executed_units)
    edges=$(sed -nE 's/.* cov: ([0-9]+).*/\1/p' "$log" | tail -1)
    printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$commit" "$target" "$seconds" "${executions:-0}" "${edges:-0}" \
        $((code != 0)) >>"$ledger"
    printf '  %-12s %11s executions, %5s edges, %s\n' "$target" "${executions:-0}" "${edges:-0}" \
        "$([ $code -eq 0 ] && echo 'no finding' || echo "exit $code: see $log")"
    [ $code -eq 0 ] || worst=1
done
awk -F'\t' 'NR > 1 { runs++; sum += $4; findings += $6 }
    END { printf "  all runs so far: %.1f million executions in %d runs, %d findings\n", sum / 1e6, runs, findings }' "$ledger"
exit $worst
