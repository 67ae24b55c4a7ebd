# plug.sh -- a machine whose power is cut: a QEMU process that is killed, on a disk that loses
# writes that were not flushed (cut.c). Source this file with a name, like disk.sh.
# An emulated boot takes a minute, and only its last seconds use the database. Most starts
# therefore begin from a snapshot of the machine before it opens its data partition
# (guest/photo.sh). The file system check, the mount, the check of the data partition and the start
# of the kiosk run each time. The snapshot has no screen, which the kiosk must support. A processor
# that draws no picture plays in real time, so ten times as many power cuts take the same time.
# shellcheck shell=bash disable=SC2154,SC1091,SC2034  # the sourcing scripts use these variables
. "$(dirname "${BASH_SOURCE[0]}")/disk.sh" "$1"
base=$cache/base.img log=$cache/writes.log
[ "${SCREEN:-yes}" = yes ] || remove_screen
# whole is a complete boot, taking the run until the snapshot, and photo a start from the snapshot.
begins=whole

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

# The kiosk has few fish and draws by softpipe, whose shaders need no compiler. A credit costs five
# coins. With two coins more credits would be returned than played, until the kiosk reaches its
# limit of 99 credits and rejects coins.
make_machine() { # SCRIPT of guest/
    make_share "$1"
    sed -i 's/ --fish [0-9]*/ --fish 3/; s/ --coins 2/ --coins 5/' "$share/units/kingyo.service.d/test.conf"
    echo 'Environment=GALLIUM_DRIVER=softpipe' >>"$share/units/kingyo.service.d/test.conf"
    cp --sparse=always "$base" "$disk"
    : >"$log"
    mkfifo "$run/go.in" "$run/go.out"
    [ "${SCREEN:-yes}" = yes ] || expect_no_screen
}

pull_plug() {
    [ ! -s "$run/pid" ] || kill -KILL "$(cat "$run/pid")" 2>/dev/null || true
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

is_running() { qmp query-status && tail -1 "$run/qmp.log" | grep -q '"status": "running"'; }

# A machine that is still being restored ignores messages, so this function waits until the machine
# runs.
begin_from_photo() {
    within 60 is_running && echo go >"$run/go.in"
}

take_photo() { # LIMIT_S
    begins=taking
    make_machine load
    : >"$share/photo"
    guest_start "$1"
    within "$1" is_posed && qmp migrate "\"uri\":\"exec:cat >$photo\"" && within "$1" is_taken || {
        echo "kills: no snapshot of the machine: $(tail -1 "$run/console")"
        return 1
    }
    pull_plug
    wait "$qemu_pid" 2>/dev/null || true
    qemu_pid=''
}
