# plug.sh -- a machine whose plug is pulled: QEMU, which is killed, over a disk that loses what was not flushed (cut.c).
# Source it with a name as disk.sh wants it.
#
# A boot by software takes a minute, of which the store sees the last seconds. So most starts begin from a photo of the
# machine, taken just before it looks at its data partition (guest/photo.sh): fsck, mount, the check that it keeps, and the
# stall's own start are done anew each time. Its screen is pulled out then, as a stall must bear it: a processor that has
# no picture to draw plays in real time, and in the same minutes it falls ten times as often.
# shellcheck shell=bash disable=SC2154,SC1091,SC2034  # who sources it uses what it sets
. "$(dirname "${BASH_SOURCE[0]}")/disk.sh" "$1"
base=$cache/base.img log=$cache/writes.log
begins=whole # whole; taking: until the photo; photo: from it

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

# Few fish, and where there is a picture one by softpipe, whose shaders need no compiler. Of a credit for two coins more
# would be given back than played, until the stall has the 99 that it may and sends coins back.
make_machine() { # SCRIPT of guest/
    make_share "$1"
    sed -i 's/ --fish [0-9]*/ --fish 3/; s/ --coins 2/ --coins 5/' "$share/units/kingyo.service.d/test.conf"
    echo 'Environment=GALLIUM_DRIVER=softpipe' >>"$share/units/kingyo.service.d/test.conf"
    cp --sparse=always "$base" "$disk"
    : >"$log"
    mkfifo "$run/go.in" "$run/go.out"
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

# What is said to a machine that is still being put together is not heard.
begin_from_photo() {
    within 60 is_running && echo go >"$run/go.in"
}

take_photo() { # LIMIT_S
    begins=taking
    make_machine load
    : >"$share/photo"
    guest_start "$1"
    within "$1" is_posed && qmp migrate "\"uri\":\"exec:cat >$photo\"" && within "$1" is_taken || {
        echo "kills: no photo of the machine: $(tail -1 "$run/console")"
        return 1
    }
    pull_plug
    wait "$qemu_pid" 2>/dev/null || true
    qemu_pid=''
}
