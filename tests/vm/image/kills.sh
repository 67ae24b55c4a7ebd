#!/bin/bash
# kills.sh -- pulls the plug of the machine KILLS times, at random moments while it starts, while coins fall and rounds run,
# and looks at what the stall still knows when it is switched on again.
#
# JOBS machines side by side, each with a disk of its own (chain.sh), a line for each kill, then the sums. SEED=N chooses
# the moments and what is lost; COINS=N: at most so many fall before a kill (25); COLD=1: each start is whole; LIES=1 makes
# the disk keep nothing of what it flushed, and then this must fail. Exit code 0: nothing that was acknowledged was ever
# lost or doubled, and each start opened.
# shellcheck disable=SC2154,SC1091,SC2034,SC2086  # what it sources sets and uses them
export BUILD=${BUILD:-build}
. "$(dirname "$0")/plug.sh" image-kills
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

needs_photo() { # Some chain has a start between its first and its last.
    [ "${COLD:-0}" = 0 ] && [ $(((kills + jobs - 1) / jobs)) -gt 1 ]
}

rm -rf "$cache"/[0-9]* "$photo"
make_test_initrd
cp --sparse=always "$image/kingyo.img" "$base"
if needs_photo; then
    take_photo "$limit_s" || exit 1
    printf '[%4d s] a photo of the machine just before it looks at its data partition: %d MiB\n' "$SECONDS" $(($(stat -c %s "$photo") >> 20))
fi
printf '[%4d s] %d kills of %d machines side by side, seed %d\n' "$SECONDS" "$kills" "$jobs" "${SEED:-1}"
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
cat "$cache"/[0-9]*/sums | awk -v jobs="$jobs" -v failed="$failed" -v seconds="$SECONDS" -v due="$kills" '
    { for (i = 1; i <= 12; i++) sum[i] += $i }
    END {
        printf "kills: %d of %d, %d of them as it started; %d starts looked at what was there\n", sum[1], due, sum[3], sum[2]
        printf "kills: %d of these found an open round, and all that lived to tell, %d, gave it back once\n", sum[4], sum[5]
        printf "kills: %d entries acknowledged, %d coins; %d writes flushed, of the others %d there, %d torn, %d lost\n",
            sum[6], sum[7], sum[8], sum[9], sum[10], sum[11]
        printf "kills: %d failures, %d s\n", sum[12], seconds
        if (NR < jobs || failed) exit 1
        if (sum[1] < due) { print "kills: not all of them were made"; exit 1 }
        if (sum[6] == 0) { print "kills: nothing was ever acknowledged, so nothing was seen"; exit 1 }
    }'
