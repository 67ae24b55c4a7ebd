#!/bin/bash
# test-vm.sh -- boots the guest GUEST, drives the kiosk in it from outside and checks the results.
# All fetched and built files are kept in BUILD/vm/GUEST: run/ has the logs, shots/ the pictures.
# Exit code 0 if every line of checks.txt passed, otherwise 1.
# shellcheck disable=SC2154,SC1091,SC2034  # lib.sh and qemu.sh set and use these variables
export GUEST=${GUEST:-bookworm} BUILD=${BUILD:-build}
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"
. "$(dirname "$0")/qemu.sh"
. "$(dirname "$0")/results.sh"
width=320 height=240
# The guest's programs are emulated. Before its first picture the kiosk compiles all shaders, which
# takes minutes, and more than six minutes on a busy machine. The shaders are kept for the next run.
limit_s=${VM_SECONDS:-1000} patience_s=${VM_PATIENCE:-120}
writer_pid='' planner_pid='' hanging=0

leave() {
    guest_stop
    for pid in $writer_pid $planner_pid; do
        kill "$pid" 2>/dev/null || true
    done
}
trap leave EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

# Creates the users and groups of the guest, with ours as systemd-sysusers creates them.
make_users() { # FOLDER
    mkdir -p "$1"/{etc,usr/lib/sysusers.d}
    unsquashfs -cat "$cache/root.sqfs" etc/passwd >"$1/etc/passwd"
    unsquashfs -cat "$cache/root.sqfs" etc/group >"$1/etc/group"
    cp "$top/board/sysusers/kingyo.conf" "$1/usr/lib/sysusers.d/"
    systemd-sysusers --root="$1" kingyo.conf
}

make_share() {
    rm -rf "$run" "$shots"
    mkdir -p "$share"/{bin,out,shots} "$shots"
    cp -r "$here/guest" "$top/board/udev" "$share/"
    cp "$programs"/{kingyo,kingyoctl,kingyo-poi} "$programs"/tests/vm/{watchdog_host,as,panel,lag} \
        "$top/board/poi-gadget/kingyo-poi-gadget" "$share/bin/"
    make_users "$share"
    chmod 777 "$share/out"
    echo "${VM_PARTS:-play hang}" >"$share/parts"
    echo "$patience_s" >"$share/patience"
    [ ! -d "$cache/mesa" ] || cp -r "$cache/mesa" "$share/mesa"
}

plan_scoops() { # Runs in the background. The guest continues when plan-done exists.
    local status=0
    "$BUILD/tests/vm/scoop_planner" "$share/out/play.kgr" "$share" "$patience_s" >"$share/plan.log" 2>&1 || status=$?
    echo "$status" >"$share/plan-done"
}

heard() { # Handles one line from the guest (guest/lib.sh).
    set -- $1
    case ${2-} in
        ok | bad) record_result "${@:2}" ;;
        booted) record_result ok boot "${*:3}" ;;
        plan) plan_scoops & planner_pid=$! ;;
        the) hanging=1 ;; # "the kiosk is stopped"
        not) hanging=0 ;;
        '#') [ "${V:-0}" = 0 ] || echo "       $*" ;;
    esac
    [ "${2-}" = '#' ] || printf '       %s\n' "$*"
}

check_pictures() {
    check_tank attract picture
    if [ -f "$shots/paused.png" ] && [ -f "$shots/resumed.png" ]; then
        local dark light
        dark=$(middle "$shots/paused.png")
        light=$(middle "$shots/resumed.png")
        passes paused "the brightness of the middle is $dark of 1000, and $light when the round continues" \
            -- [ "$dark" -lt "$MIDDLE_DARK" -a "$light" -gt "$MIDDLE_LIGHT" ]
    fi
}

seen() { # NAME: Prints the latest value of NAME from state_writer.c.
    sed -n "s/^$1 //p" "$share/seen" 2>/dev/null || true
}

# Prints kernel warnings except one. When a chip is removed, Linux 6.12 frees the interrupts of its
# lines, and frees them again when the process that holds the lines closes them (linereq_free). The
# kernel warns about this without any other effect.
warnings() {
    grep -hA1 'cut here' "$run/console" "$share/out/dmesg" 2>/dev/null |
        grep -vE 'cut here|^--|Trying to free already-free IRQ' | head -1 || true
}

check_logs() {
    local out=$share/out/kingyo.out err=$share/out/kingyo.err line
    line=$(first 'arrival' "$out")
    passes latency "${line:-the kiosk reports no latency}" -- [ -n "$line" ]
    line=$(first 'watchdog_host: fed' "$err")
    passes fed "${line:-the watchdog was not fed}" -- [ "${line:+1}" = 1 ]
    line=$(first 'BUG:|Oops|segfault|general protection|Kernel panic|hung task' "$run/console" "$share/out/dmesg")
    [ -n "$line" ] || line=$(warnings)
    [ -n "$line" ] || line=$(first 'panic|assert|anitizer|egmentation|aborted' "$err")
    passes crash "${line:-$(wc -l <"$run/console") lines of the kernel, $(grep -vc '^watchdog_host' "$err") of the kiosk}" -- [ -z "$line" ]
    passes twin "$(seen ticks) ticks; the first difference: $(seen differs_at)" -- grep -q '^differs_at 0' "$share/seen"
}

check_watchdog() { # QEMU reports when a watchdog expires, and why QEMU ended.
    local bit=no
    grep -q '"WATCHDOG"' "$run/qmp.log" && bit=yes
    passes watchdog "hanging: $hanging, expired: $bit" -- [ "$hanging$bit" = 1yes ]
}

"$here/prepare.sh"
programs=$("$here/programs.sh")
make_share
step "boot ${GUEST}"
guest_start "$limit_s"
"$BUILD/tests/vm/state_writer" "$share/out/play.kgr" "$share/seen" &
writer_pid=$!
guest_listen
step "the guest is off (qemu ended with $qemu_status)"
[ ! -d "$share/out/mesa" ] || { rm -rf "$cache/mesa"; mv "$share/out/mesa" "$cache/mesa"; }
sleep 1
kill "$writer_pid" 2>/dev/null || true
wait "$writer_pid" || true
writer_pid=''
check_pictures
check_logs
check_watchdog
table "$here/checks.txt" "$GUEST: $(cat "$cache/kernel/release")" | tee "$cache/table.txt"
exit "${PIPESTATUS[0]}"
