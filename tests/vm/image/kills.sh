#!/bin/bash
# kills.sh -- pulls the plug of the machine KILLS times, at random moments while coins fall and rounds run, and looks at
# what the stall still knows when it is switched on again.
#
# The machine is QEMU, which is killed; its disk loses what was not flushed, in any order and by halves (cut.c). What the
# stall had been told is safe is computed from its recording, which lies outside (witness.c).
#
# A boot by software takes a minute, of which the store sees the last seconds. So the first start and the last are whole;
# the others begin from a photo of the machine, taken just before it looks at its data partition (guest/photo.sh):
# fsck, mount, the check that it keeps, and the stall's own start are done anew each time. COLD=1: each start is whole.
# SEED=N chooses the moments, and what is lost; LIES=1 makes the disk keep nothing that it flushed, and then this must
# fail. Exit code 0: nothing that was acknowledged was ever lost or doubled, and each start opened.
# shellcheck disable=SC2154,SC1091,SC2034,SC2086  # what it sources sets and uses them
export BUILD=${BUILD:-build}
. "$(dirname "$0")/disk.sh" image-kills
kills=${KILLS:-50} seed=${SEED:-1} limit_s=${VM_SECONDS:-600}
coins_max=${COINS:-40} cold=${COLD:-0} lies=${LIES:+lies}
base=$cache/base.img log=$cache/writes.log photo=$cache/photo
begins=whole # photo: from it; taking: it is being taken
loading=0 fallen=0 recording='' kill=0 boot=0
acknowledged_all=0 coins_all=0 failures=0 lost=''
RANDOM=$seed

leave() {
    [ ! -s "$run/pid" ] || kill -KILL "$(cat "$run/pid")" 2>/dev/null || true
    guest_stop
}
trap leave EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

disk_words() {
    printf '%s\n' -pidfile "$run/pid" -serial "pipe:$run/go"
    case $begins in
        taking) printf '%s\n' -blockdev "driver=file,node-name=disk,filename=$disk" ;;
        *) printf '%s\n' -blockdev \
            "driver=blklogwrites,node-name=disk,file.driver=file,file.filename=$disk,log.driver=file,log.filename=$log" ;;
    esac
    printf '%s\n' -device virtio-blk-pci,drive=disk,write-cache=on
    [ "$begins" != photo ] || printf '%s\n' -incoming "exec:cat $photo"
}

# Few fish, and a picture by softpipe, whose shaders need no compiler: the machine has its time for coins.
make_machine() {
    make_share load
    sed -i 's/ --fish [0-9]*/ --fish 3/' "$share/units/kingyo.service.d/test.conf"
    echo 'Environment=GALLIUM_DRIVER=softpipe' >>"$share/units/kingyo.service.d/test.conf"
    cp --sparse=always "$base" "$disk"
    : >"$log"
    mkfifo "$run/go.in" "$run/go.out"
}

within() { # SECONDS COMMAND...
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        kill -0 "$qemu_pid" 2>/dev/null && [ "$SECONDS" -lt "$end" ] || return 1
        sleep 0.2
    done
}

is_posed() { grep -q 'kingyo-test: photo' "$run/console"; }

is_taken() {
    qmp query-migrate && grep "\"id\": $qmp_id\b" "$run/qmp.log" | grep -q '"status": "completed"'
}

take_photo() {
    begins=taking
    make_machine
    : >"$share/photo"
    guest_start "$limit_s"
    if ! within "$limit_s" is_posed || ! qmp migrate "\"uri\":\"exec:cat >$photo\"" || ! within "$limit_s" is_taken; then
        echo "kills: no photo of the machine: $(tail -1 "$run/console")"
        exit 1
    fi
    kill -KILL "$(cat "$run/pid")"
    wait "$qemu_pid" 2>/dev/null || true
    printf 'kills: a photo of the machine, %d MiB, after %d s\n' $(($(stat -c %s "$photo") >> 20)) "$SECONDS"
}

bad() { # WORDS
    failures=$((failures + 1))
    printf '       FAIL %s\n' "$*"
}

heard() {
    set -- $1
    case ${2-} in
        recording) recording=$3 ;;
        load) loading=1 ;;
        coin)
            fallen=$3
            [ "$fallen" -ne "$pull_at" ] || pull_plug_soon &
            ;;
        bad) bad "start $start: ${*:3}" ;;
    esac
}

pull_plug_soon() { # Within the second
    sleep "$(awk "BEGIN { print $RANDOM / 32768 }")"
    kill -KILL "$(cat "$run/pid")"
}

ask() { # SQL, of what the newest start found on its disk
    sqlite3 "$share/out/kept/kingyo.db" "$1"
}

# What was found on the disk against what the stall before had said. Both know entries by their ids.
compare() { # WITNESS FALLEN
    local acknowledged newest found_to count paid coins doubled
    [ -s "$share/out/kept/kingyo.db" ] || { bad "kill $kill: there is no store"; return; }
    grep -q '^kept' "$share/out/kept/data" || bad "kill $kill: $(cat "$share/out/kept/data")"
    [ "$(ask 'PRAGMA integrity_check')" = ok ] || bad "kill $kill: the store is damaged: $(ask 'PRAGMA integrity_check' | head -1)"
    read -r _ _ acknowledged newest _ < <(grep '^end' "$1")
    read -r found_to count < <(ask 'SELECT coalesce(max(id), 0), count(*) FROM entries' | tr '|' ' ')
    [ "$found_to" -ge "$acknowledged" ] || bad "kill $kill: entry $acknowledged was acknowledged; the disk has $found_to"
    [ "$count" -eq "$found_to" ] || bad "kill $kill: $count entries up to $found_to"
    # Each that both know is the same; what the recording's last second did not tell is on the disk alone.
    ask "SELECT id, boot, tick, kind, detail, count, value, units, bonus_units, paid, service, untold, open FROM entries" |
        tr '|' ' ' | sed 's/^/entry /' | sort >"$cache/disk.txt"
    grep '^entry' "$1" | awk -v to="$found_to" '$2 <= to' | sort >"$cache/told.txt"
    doubled=$(comm -13 "$cache/disk.txt" "$cache/told.txt" | head -1)
    [ -z "$doubled" ] || bad "kill $kill: the disk has another: $doubled"
    coins=$(ask "SELECT coalesce(sum(count), 0) FROM entries WHERE kind = 2 AND boot = $boot")
    [ "$coins" -le "$2" ] || bad "kill $kill: $coins coins of $2 that fell"
    acknowledged_all=$((acknowledged_all + $(awk -v to="$acknowledged" '/^entry/ && $2 <= to' "$1" | wc -l)))
    coins_all=$((coins_all + coins))
    printf '       kill %d: acknowledged up to %d, on the disk up to %d of %d; %d of %d coins; %s; %d s, %s start\n' "$kill" \
        "$acknowledged" "$found_to" "$newest" "$coins" "$2" "$lost" "$((SECONDS - switched_on))" "$begins"
}

start_once() {
    begins=photo
    [ "$cold" = 0 ] && [ "$start" -gt 1 ] && [ "$start" -le "$kills" ] || begins=whole
    [ "$begins" = whole ] || [ -s "$photo" ] || { take_photo; begins=photo; }
    make_machine
    loading=0 fallen=0 recording='' pull_at=$((10 + RANDOM % coins_max)) # A recording is a second late.
    guest_start "$limit_s" || true
    [ "$begins" = whole ] || echo go >"$run/go.in"
    guest_listen
}

make_test_initrd
rm -f "$photo"
cp --sparse=always "$image/kingyo.img" "$base"
for ((start = 1; start <= kills + 1; start++)); do
    before=$fallen kill=$((start - 1)) switched_on=$SECONDS
    start_once
    keep_shaders
    [ "$loading" = 1 ] || bad "start $start: it never opened"
    [ "$qemu_status" -eq 137 ] || bad "start $start: the machine ended by itself, with $qemu_status"
    [ "$kill" -eq 0 ] || compare "$cache/witness.txt" "$before"
    "$BUILD/tests/vm/image/witness" "$share/out/$recording" >"$cache/witness.txt" || bad "start $start: no witness"
    boot=$(awk '/^start/ { print $3 }' "$cache/witness.txt")
    lost=$("$BUILD/tests/vm/image/cut" "$log" "$base" "$((seed * 1000 + start))" $lies)
done
printf 'kills: %d, %d entries acknowledged, %d coins; %d failures, %d s\n' "$kills" "$acknowledged_all" "$coins_all" "$failures" "$SECONDS"
[ "$acknowledged_all" -gt 0 ] || { echo "kills: nothing was ever acknowledged, so nothing was seen"; exit 1; }
[ "$failures" -eq 0 ]
