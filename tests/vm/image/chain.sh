#!/bin/bash
# chain.sh JOB KILLS -- one machine whose power is cut KILLS times. Each start has the disk that
# the previous power cut left.
# kills.sh starts this script, with a snapshot of the machine in build/vm/image-kills/, and adds up
# the results in build/vm/image-kills/JOB/sums. The first and the last start are complete boots
# with a picture (COLD=1: all starts are). A random quarter of the other starts loses its power
# during the start, between the check of the disk and the first coin. The rest lose it within a
# second after a random coin, usually during a round. The script stops at the first error and keeps
# disk, log and recording. Exit code 0 means that there was no error.
# shellcheck disable=SC2154,SC1091,SC2034  # the sourced files set and use these variables
export BUILD=${BUILD:-build}
job=$1 kills=$2
. "$(dirname "$0")/plug.sh" "${CARD:-image}-kills/$job"
. "$(dirname "$0")/check_ledger.sh"
photo=$cache/../photo initrd=$cache/../initrd.zst
seed=$((${SEED:-1} * 100 + job)) limit_s=${VM_SECONDS:-600} coins_max=${COINS:-25} cold=${COLD:-0} lies=${LIES:+lies}
# Time from the check of the disk to the first coin. Replaced by the measured time.
start_ms=${START_MS:-20000}
processors=${PROCESSORS:-2}
failures=0 kill=0 starts_hit=0 rounds_hit=0 refunds=0 reported_all=0 checks=0
RANDOM=$seed

leave() {
    pull_plug
    guest_stop
}
trap leave EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

bad() { # WORDS
    failures=$((failures + 1))
    printf '       FAIL %s.%d: %s\n' "$job" "$kill" "$*"
}

now_ms() { date +%s%3N; }

heard() { # Handles one line from the guest (guest/load.sh).
    set -- $1
    case ${2-} in
        load)
            loading=1
            [ "$begins" = whole ] || start_ms=$(($(now_ms) - switched_on))
            ;;
        coin)
            fallen=$3
            [ "$fallen" -ne "$pull_at" ] || pull_in "$pull_ms" &
            ;;
        bad) bad "${*:3}" ;;
    esac
}

pull_in() { # MS
    sleep "$(($1 / 1000)).$(printf %03d $(($1 % 1000)))"
    pull_plug
}

choose_moment() {
    begins=photo pull_at=$((1 + RANDOM % coins_max)) pull_ms=$((RANDOM % 1000))
    if [ "$cold" != 0 ] || [ "$kill" -eq 1 ] || [ "$kill" -gt "$kills" ]; then
        # Pictures slow the machine down, so this many coins are inserted until the first one is
        # saved.
        begins=whole pull_at=$((pull_at + 20))
        [ "$kill" -le "$kills" ] || pull_at=1  # No later start checks the entries of this start.
    elif [ $((RANDOM % 4)) -eq 0 ]; then
        pull_at=0 pull_ms=$((RANDOM * start_ms / 32768))
    fi
}

start_once() {
    choose_moment
    make_machine load
    loading=0 fallen=0 puller=''
    guest_start "$limit_s" || true
    [ "$begins" = whole ] || begin_from_photo
    switched_on=$(now_ms)
    [ "$pull_at" -ne 0 ] || { pull_in "$pull_ms" & puller=$!; }
    guest_listen
    [ -z "$puller" ] || kill "$puller" 2>/dev/null || true
    keep_shaders
}

# Checks the entries that this start found, the entries it reported, and its disk after the power
# cut.
check_start() {
    found='lost its power before the check' refunded=0 reported_count=0
    if check_disk_ledger; then
        checks=$((checks + 1))
        found="found entries up to $found_to"
        [ "$found_open" = 0 ] || { found+=', a round was open'; rounds_hit=$((rounds_hit + 1)); }
    fi
    [ "$failures" -eq 0 ] || return 0
    check_reported_ledger "$fallen" || true
    refunds=$((refunds + refunded)) reported_all=$((reported_all + reported_count))
    [ "$failures" -eq 0 ] || return 0
    lost=$("$BUILD/tests/vm/image/cut" "$log" "$base" "$((seed * 1000 + kill))" $lies)
    [ "$kill" -gt "$kills" ] || echo "$lost" | tr -dc '0-9 \n' >>"$cache/writes.txt"
}

when() {
    if [ "$loading" = 1 ]; then echo "at coin $fallen"; else echo 'during the start'; fi
}

print_progress() {
    printf '       kill %s.%d, %s: %d more entries acknowledged; %s. %d.%d s, this start %s\n' "$job" "$kill" "$(when)" \
        "$reported_count" "$lost" $((lived_ms / 1000)) $((lived_ms / 100 % 10)) "$found"
}

fresh_disk "$base"
: >"$cache/writes.txt"
for ((kill = 1; kill <= kills + 1; kill++)); do
    start_once
    lived_ms=$(($(now_ms) - switched_on))
    [ "$qemu_status" -eq 137 ] || bad "the machine ended before the power cut, with $qemu_status"
    [ "$loading" = 1 ] || [ -n "$puller" ] || bad 'the kiosk did not open'
    check_start
    [ "$failures" -eq 0 ] || break
    if [ "$kill" -le "$kills" ]; then
        [ "$loading" = 1 ] || starts_hit=$((starts_hit + 1))
        print_progress
    else
        printf '       the last start of %s %s, and opened\n' "$job" "$found"
    fi
done

# Columns: kills, checked starts, kills during a start, open rounds, returned credits, entries,
# coins; writes flushed, kept, torn, lost; failures.
made=$((kill - 1 < kills ? kill - 1 : kills))
coins=$(awk '$4 == 2 { sum += $6 } END { print sum + 0 }' "$cache/sure.txt")
awk -v counts="$made $checks $starts_hit $rounds_hit $refunds $reported_all $coins" -v failures="$failures" \
    '{ for (i = 1; i <= 5; i++) sum[i] += $i } END { print counts, sum[1] + 0, sum[3] + 0, sum[4] + 0, sum[5] + 0, failures }' \
    "$cache/writes.txt" >"$cache/sums"
[ "$failures" -eq 0 ]
