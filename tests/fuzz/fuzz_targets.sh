#!/bin/bash
# fuzz_targets.sh KIND FOLDER SECONDS TARGET... -- runs each target of a KIND (device, file) for
# SECONDS, and counts the findings.
# FOLDER (build/fuzz) contains the programs KIND_TARGET, the inputs that reached new code
# (corpus/TARGET), findings, one log for each target, and KINDs.tsv. Every run adds a row to
# KINDs.tsv, which therefore has the sum of all runs. Exits with 1 if there is a finding. MAX_LEN
# is the maximum input size in bytes (4096).
set -u
kind=$1 folder=$2 seconds=$3
shift 3
ledger=$folder/${kind}s.tsv
mkdir -p "$folder/findings"
[ -s "$ledger" ] || printf 'commit\ttarget\tseconds\texecutions\tedges\tfindings\n' >"$ledger"
commit=$(git rev-parse --short HEAD 2>/dev/null || echo none)
worst=0
# Targets that need files create them in memory if the system has such a folder.
TMPDIR=$(mktemp -d -p /dev/shm 2>/dev/null || mktemp -d)
export TMPDIR
# The quarantine of freed memory would otherwise exceed the memory limit below.
export ASAN_OPTIONS=${ASAN_OPTIONS:-quarantine_size_mb=32}
trap 'rm -rf "$TMPDIR"' EXIT

"tests/fuzz/${kind}_seeds.sh" "$folder/seeds" || exit 1
stat_of() { sed -n "s/^stat::$2: *//p" "$1" | tail -1; }

for target in "$@"; do
    log=$folder/$target.log
    seeds=
    for of in "tests/fuzz/corpus/$target" "$folder/seeds/$target"; do [ -d "$of" ] && seeds+=" $of"; done
    mkdir -p "$folder/corpus/$target"
    # shellcheck disable=SC2086
    nice "$folder/${kind}_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=1024 \
        -max_len="${MAX_LEN:-4096}" -close_fd_mask=1 -print_final_stats=1 \
        -artifact_prefix="$folder/findings/$target-" "$folder/corpus/$target" $seeds >"$log" 2>&1
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
