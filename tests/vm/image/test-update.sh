#!/bin/bash
# test-update.sh -- updates the disk of `make image BOARD=vm` from USB sticks in an emulated machine. CARD=rpi4 updates the
# card of that board in QEMU's machine `virt`.
#
# The update is a system that does not open a kiosk, so that the machine must return to the old one. All writes of the
# update are logged; the power is then cut after each entry of the log (COUNT cuts, drawn by SEED), on copies of the disk.
# A second system (part failing) is complete, but its kiosk exits or never shows a picture, so that the machine must return again.
# PARTS=sticks or PARTS=failing runs one of these two parts. Checks of the other are printed as not run.
# Exit code 0 if every line of update_checks.txt passed, otherwise 1.
# shellcheck disable=SC2154,SC1091,SC2034  # the sourced files set and use these variables
export BUILD=${BUILD:-build}
. "$(dirname "$0")/disk.sh" "${CARD:-image}-update"
. "$top/board/image/slots/slots.sh"
target=${CARD:-vm} other=rpi4 console=ttyS0 limit_s=${VM_SECONDS:-1800}
[ -z "$CARD" ] || other=vm console=ttyAMA0 limit_s=${VM_SECONDS:-7200}
cuts=${COUNT:-200} seed=${SEED:-1}
disk=$cache/disk.img # A later start has the disk of the start before.
key=$BUILD/vm/update.key log=$cache/writes.log plugged='' plug_count=0 faults=''
trap guest_stop EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

disk_words() { # All writes are logged. The machine has a USB controller, but no screen, which would be slow.
    printf '%s\n' -device qemu-xhci,id=xhci -blockdev \
        "driver=blklogwrites,node-name=disk,file.driver=file,file.filename=$disk,log.driver=file,log.filename=$log" \
        -device virtio-blk-pci,drive=disk,write-cache=on
}

remove_screen
# ---- Packages and sticks

make_system() { # FILE: a system that prints a line and restarts, with room for many chunks
    local root=$cache/bad
    rm -rf "$root"
    mkdir -p "$root"/{bin,sbin,proc,sys,dev,run,usr/lib/modules}
    cp "$busybox" "$root/bin/busybox"
    printf '%s\n' '#!/bin/busybox sh' '/bin/busybox echo "kingyo-test: slot $(/bin/busybox cat /run/kingyo-slot)" >/dev/'"$console" \
        '/bin/busybox sleep 1' '/bin/busybox reboot -f' >"$root/sbin/init"
    chmod +x "$root/sbin/init"
    head -c 14000000 /dev/urandom >"$root/filler"
    rm -f "$1"
    mksquashfs "$root" "$1" -noappend -quiet -no-progress >/dev/null
}

package() { # NAME BOARD VERSION [KEY]: a stick with a package
    "$top/board/image/update/make_package.sh" "$cache/new.sqfs" "$2" "$3" "Kingyo test $3" "${4:-$key}" "$cache/packages/$1"
}

stick_of() { # NAME: makes the stick of a package, if there is one.
    local file=$cache/sticks/$1
    truncate -s 40M "$file"
    mkfs.vfat "$file" >/dev/null
    if [ -d "$cache/packages/$1" ]; then
        mmd -i "$file" ::/kingyo-update
        mcopy -i "$file" "$cache/packages/$1"/* ::/kingyo-update/
    fi
}

make_sticks() {
    local version name
    version=$(sed -n 's/^version //p' "$image/update-version")
    rm -rf "$cache/packages" "$cache/sticks"
    mkdir -p "$cache/packages" "$cache/sticks"
    minisign -G -f -W -p "$cache/other.pub" -s "$cache/other" >/dev/null
    make_system "$cache/new.sqfs"
    for name in good unsigned damaged; do package "$name" "$target" $((version + 1)); done
    package wrong-key "$target" $((version + 1)) "$cache/other"
    package older "$target" $((version - 1))
    package board "$other" $((version + 1))
    rm "$cache/packages/unsigned/manifest.minisig"
    printf x | dd of="$cache/packages/damaged/root.sqfs" bs=1 seek=9000000 conv=notrunc status=none
    (cp "$cache/new.sqfs" "$cache/large.sqfs" && truncate -s 400M "$cache/large.sqfs" &&
        "$top/board/image/update/make_package.sh" "$cache/large.sqfs" "$target" $((version + 1)) 'Kingyo test' "$key" "$cache/packages/large" &&
        cp "$cache/new.sqfs" "$cache/packages/large/root.sqfs" && rm "$cache/large.sqfs")
    for name in good unsigned damaged wrong-key older board large empty; do stick_of "$name"; done
    head -c 4000000 /dev/urandom >"$cache/sticks/noise"
    faults='noise:no-filesystem empty:no-folder unsigned:unsigned wrong-key:wrong-key older:older board:wrong-board
        large:too-large'
}

exchange() { # NAME or none
    if [ -n "$plugged" ]; then
        qmp device_del "\"id\":\"$plugged\"" || true
        sleep 1
    fi
    plugged=''
    if [ "$1" != none ]; then
        plug_count=$((plug_count + 1)) plugged=usb$plug_count
        qmp blockdev-add "\"driver\":\"raw\",\"node-name\":\"node$plug_count\",\"read-only\":true,\"file\":{\"driver\":\"file\",\"filename\":\"$cache/sticks/$1\"}"
        qmp device_add "\"driver\":\"usb-storage\",\"id\":\"$plugged\",\"drive\":\"node$plug_count\",\"bus\":\"xhci.0\""
    fi
    : >"$share/stick-done"
}

heard() { # Handles one line from the guest.
    set -- $1
    case ${2-} in
        ok | bad) record_result "${@:2}" ;;
        stick) exchange "$3" ;;
    esac
    printf '       %s\n' "$*"
}

# ---- Starts and power cuts

limit_of() { sed -n 's/^TimeoutStartSec=//p' "$top/board/$1"; } # UNIT

# The time limits of the kiosk and of the end of the trial are those of the product.
share_limits() { # PASS
    local kiosk trial
    kiosk=$(limit_of systemd/kingyo.service) trial=$(limit_of image/root/etc/systemd/system/kingyo-slot-good.service)
    [ "$1" = exits ] || : >"$share/no-frames"
    sed -i "s/^TimeoutStartSec=.*/TimeoutStartSec=${kiosk:?no limit in the unit}/" "$share/units/kingyo.service.d/test.conf"
    mkdir -p "$share/units/kingyo-slot-good.service.d"
    printf '[Service]\nTimeoutStartSec=%s\n' "${trial:?no limit in the unit}" >"$share/units/kingyo-slot-good.service.d/90-limit.conf"
}

boot() { # PASS
    make_share update
    echo "$1" >"$share/pass"
    echo "$faults" >"$share/faults"
    : >"$log"
    plugged=''
    case $1 in exits | no-frames) share_limits "$1" ;; esac
    expect_no_screen
    step "boot the disk: $1"
    guest_start "$limit_s" || true
    guest_listen
    step "the machine is off (qemu ended with $qemu_status)"
}

part_at() { # NAME: prints the start and the size of a partition in sectors. A card has numbers in place of names.
    local line
    case $CARD$1 in
        root-* | slots) line="name=\"kingyo-$1\"" ;;
        *slots) line='^[^ ]*5 : ' ;;
        *root-a) line='^[^ ]*6 : ' ;;
        *root-b) line='^[^ ]*7 : ' ;;
    esac
    sfdisk -d "$disk" | sed -n "/$line/s/.*start= *\([0-9]*\), size= *\([0-9]*\),.*/\1 \2/p"
}

part() { # NAME FROM TO: copies the beginning of a partition.
    local start size
    read -r start size < <(part_at "$1")
    [ "$size" -lt 49152 ] || size=49152 # 24 MiB, more than the system of the test.
    dd if="$2" of="$3" bs=512 skip="$start" count="$size" status=none
}

# Cuts the power after ENTRIES of the log. Sets outcome; returns 1 if neither system is complete.
cut_after() { # ENTRIES
    cp --sparse=always --reflink=auto "$cache/before.img" "$cache/cut.img"
    "$BUILD/tests/vm/image/cut" "$log" "$cache/cut.img" $((seed * 100000 + $1)) "$1" >/dev/null
    part slots "$cache/cut.img" "$cache/cut.slots"
    part root-b "$cache/cut.img" "$cache/cut.root"
    slots_read "$cache/cut.slots" || return 1
    outcome=old
    [ "$good" = a ] || return 1
    if [ "$trial" = b ]; then
        outcome=new
        [ "$starts" -eq 2 ] && cmp -s -n "$(stat -c %s "$cache/new.sqfs")" "$cache/cut.root" "$cache/new.sqfs"
    fi
}

cut_all() {
    local entries at old=0 new=0 bad=0
    entries=$(cp --sparse=always "$cache/before.img" "$cache/cut.img" && "$BUILD/tests/vm/image/cut" "$log" "$cache/cut.img" 1 | sed 's/.* \([0-9]*\) entries/\1/')
    RANDOM=$seed
    for ((cut = 0; cut < cuts; cut++)); do
        at=$((cut * entries / cuts + (RANDOM * 32768 + RANDOM) % (entries / cuts + 1)))
        if cut_after "$at"; then
            [ "$outcome" = old ] && old=$((old + 1)) || new=$((new + 1))
        else
            bad=$((bad + 1))
            echo "       FAIL: cut after $at of $entries entries: $good $trial $starts"
        fi
    done
    rm -f "$cache/cut.img" "$cache/cut.root"
    passes cuts "$cuts cuts in a log of $entries entries: $old old, $new new, $bad bad" -- \
        [ "$((bad == 0 && old > 0 && new > 0))" -eq 1 ]
}

trial_start() { # ID
    boot "$1"
    line=$(grep -ao 'kingyo-test: slot .' "$run/console" | tail -1) || :
    passes "$1" "${line:-no line of the new system}" -- [ "$line" = 'kingyo-test: slot b' ]
}

# Writes a system to slot b, on trial, as an update would.
put_system() { # FILE
    local to slots
    read -r to _ < <(part_at root-b)
    read -r slots _ < <(part_at slots)
    dd if="$1" of="$disk" bs=1M oflag=seek_bytes seek=$((to * 512)) conv=notrunc status=none
    part slots "$disk" "$cache/trial.slots"
    slots_write "$cache/trial.slots" a b 2
    dd if="$cache/trial.slots" of="$disk" bs=512 seek="$slots" conv=notrunc status=none
}

# Makes the system of the image with another kiosk: one that exits, or that runs without a picture (share/no-frames).
make_failing() { # FILE
    local root=$cache/failing
    rm -rf "$root" "$1"
    unsquashfs -quiet -no-progress -d "$root" "$image/root.sqfs" >/dev/null
    printf '%s\n' '#!/bin/sh' 'echo "slot $(cat /run/kingyo-slot)" >>/run/host/out/failing' \
        '[ ! -e /run/host/no-frames ] || exec sleep 1000' 'exit 1' >"$root/usr/bin/kingyo"
    mksquashfs "$root" "$1" -noappend -quiet -no-progress -comp \
        "$(unsquashfs -s "$image/root.sqfs" | sed -n 's/^Compression //p')" >/dev/null
    rm -rf "$root"
}

# Starts the failing system. Its unit kingyo-slot-good must restart the machine after its time limit, which the emulator
# does not extend here.
failing_start() { # ID STARTS that remain
    local began=$SECONDS lines state
    boot "$1"
    part slots "$disk" "$cache/trial.slots"
    slots_read "$cache/trial.slots" && state="good $good, trial $trial, starts left $starts"
    lines=$(grep -cx 'slot b' "$share/out/failing" || :)
    passes "$1" "$lines starts of the kiosk, restart after $((SECONDS - began)) s; ${state:-no state}" -- \
        [ "$((qemu_status == 0 && lines > 0)) ${state:-}" = "1 good a, trial b, starts left $2" ]
}

check_takings() {
    local coins
    coins=$(sqlite3 "$share/out/kept/kingyo.db" 'SELECT coalesce(sum(count), 0) FROM entries WHERE kind = 2' 2>&1 | head -1) || :
    passes takings "coins in the database: $coins of 4" -- [ "$coins" = 4 ]
}

# Updates from sticks, cuts the power after each write, and starts a system that only restarts.
part_sticks() {
    make_sticks
    cp --sparse=always "$disk" "$cache/before.img"
    boot first
    passes restarts "qemu ended with $qemu_status" -- [ "$qemu_status" -eq 0 ]
    step 'cut the power after the writes of the update'
    cut_all
    trial_start trial-1
    trial_start trial-2
    boot fell-back
}

# Starts a complete system whose kiosk fails.
part_failing() {
    make_failing "$cache/failing.sqfs"
    put_system "$cache/failing.sqfs"
    rm "$cache/failing.sqfs"
    failing_start exits 1
    failing_start no-frames 0
    boot returned
    check_takings
}

parts=${PARTS:-sticks failing} checks=$run/checks.txt
case "$parts " in 'sticks ' | 'failing ' | 'sticks failing ') ;; *) echo "test-update: there are no parts '$parts'" >&2; exit 2 ;; esac
make_test_initrd
fresh_disk
case $parts in sticks*) part_sticks ;; *) boot coins ;; esac
case $parts in *failing) part_failing ;; esac
put_system "$image/root.sqfs"
boot good
check_takings
[ ! -s "$share/out/journal" ] || cp "$share/out/journal" "$cache/journal-good"
sed 's/^\([^ #]*\)  *[^ ]* */\1 /' "$here/image/update_checks.txt" >"$checks"
while read -r id part _; do
    case "# always $parts " in *" $part "*) ;; *) verdict[$id]=out ;; esac
done < <(grep -v '^#' "$here/image/update_checks.txt")
table "$checks" "the update of the disk of make image BOARD=$target" | tee "$cache/table.txt"
exit "${PIPESTATUS[0]}"
