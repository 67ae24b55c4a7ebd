#!/bin/bash
# kills.sh -- cuts the power of the machine KILLS times, at random moments while it starts, while
# coins are inserted and while rounds run. Each next start checks the saved data.
# JOBS machines run in parallel, each with its own disk (chain.sh). The script prints one line for
# each power cut, then the totals. SEED=N selects the moments and the lost writes. COINS=N is the
# maximum number of coins before a power cut (default 25). COLD=1 makes each start a complete boot.
# LIES=1 makes the disk lose flushed writes, so that the test must fail. OPEN_ROUNDS=N requires that
# N starts find a round that the power cut interrupted. CARD=rpi4 cuts the power of that board's
# card in QEMU's machine `virt`, which needs COLD=1. SCREEN=no removes the screen, which is faster. Exit code 0 means that no
# acknowledged entry was lost or duplicated, and that each start opened.
# shellcheck disable=SC2154,SC1091,SC2034,SC2086  # the sourced files set and use these variables
export BUILD=${BUILD:-build}
. "$(dirname "$0")/plug.sh" "${CARD:-image}-kills"
kills=${KILLS:-50} jobs=${JOBS:-$(nproc)} limit_s=${VM_SECONDS:-600}
jobs=$((jobs < 1 ? 1 : jobs > kills ? kills : jobs))
processors=$(($(nproc) / jobs)) photo=$cache/photo chains=''
processors=$((processors < 1 ? 1 : processors > 2 ? 2 : processors))
export PROCESSORS=$processors

leave() {
    local pid
    for pid in $chains; do
        kill "$pid" 2>/dev/null || true
    done
    pull_plug
    guest_stop
}
trap leave EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

needs_photo() { # Returns 0 if some machine has a start between its first and its last.
    [ "${COLD:-0}" = 0 ] && [ $(((kills + jobs - 1) / jobs)) -gt 1 ]
}

rm -rf "$cache"/[0-9]* "$photo"
make_test_initrd
fresh_disk "$base"
if needs_photo; then
    take_photo "$limit_s" || exit 1
    printf '[%4d s] a snapshot of the machine before it opens its data partition: %d MiB\n' "$SECONDS" $(($(stat -c %s "$photo") >> 20))
fi
printf '[%4d s] %d power cuts of %d parallel machines, seed %d\n' "$SECONDS" "$kills" "$jobs" "${SEED:-1}"
for ((job = 1; job <= jobs; job++)); do
    mkdir -p "$cache/$job"
    "$here/image/chain.sh" "$job" $(((kills + job - 1) / jobs)) &
    chains+=" $!"
done
failed=0
for pid in $chains; do
    wait "$pid" || failed=$((failed + 1))
done
chains=''
cat "$cache"/[0-9]*/sums | awk -v jobs="$jobs" -v failed="$failed" -v seconds="$SECONDS" -v due="$kills" -v open="${OPEN_ROUNDS:-0}" '
    { for (i = 1; i <= 12; i++) sum[i] += $i }
    END {
        printf "kills: %d of %d power cuts, %d of them during a start; %d starts checked the saved data\n", sum[1], due, sum[3], sum[2]
        printf "kills: %d of these found an open round; %d refundable credits were returned, each once\n", sum[4], sum[5]
        printf "kills: %d entries acknowledged, %d coins; %d writes flushed, of the others %d kept, %d torn, %d lost\n",
            sum[6], sum[7], sum[8], sum[9], sum[10], sum[11]
        printf "kills: %d failures, %d s\n", sum[12], seconds
        if (NR < jobs || failed) exit 1
        if (sum[1] < due) { print "kills: not all power cuts were made"; exit 1 }
        if (sum[4] < open) { print "kills: too few power cuts interrupted a round"; exit 1 }
        if (sum[6] == 0) { print "kills: no entry was acknowledged, so nothing was checked"; exit 1 }
    }'
