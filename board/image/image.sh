#!/bin/bash
# image.sh BOARD -- makes the disk of board/BOARD/image.conf: $IMAGE/kingyo.img, with the kiosk of $BUILD.
#
# Three scripts do the work: root.sh installs Debian's packages, boot.sh makes the kernel and the boot files, and this
# script installs the kiosk and writes the disk. Of the build machine's files, only the output of make goes into the image.
# Exit code 1: something is missing or failed; one line says what. Exit code 2: wrong usage.
# shellcheck disable=SC2154,SC1091,SC2115  # lib.sh sets them
. "$(dirname "$0")/lib.sh"
. "$here/system.sh"

install_kiosk() { # FOLDER: installs the Debian packages of this tree. packages.txt must list their dependencies.
    local root=$1
    mkdir "$root/debs"
    cp "$BUILD"/deb/kingyo_*_"$arch".deb "$BUILD"/deb/kingyo-kiosk_*.deb "$root/debs/"
    chroot "$root" env PATH=/usr/sbin:/usr/bin DEBIAN_FRONTEND=noninteractive \
        sh -c 'dpkg --install /debs/*.deb' >"$IMAGE/dpkg.log" 2>&1 || {
        tail -5 "$IMAGE/dpkg.log" >&2
        return 1
    }
    rm -r "$root/debs"
}

# Makes the data partition: empty, and owned by the kiosk.
make_data() {
    rm -f "$IMAGE/data.ext4"
    truncate -s "${data_size}M" "$IMAGE/data.ext4"
    mkfs.ext4 -q -F -L kingyo-data -m 0 -E "root_owner=$kiosk_owner,lazy_itable_init=0,lazy_journal_init=0" "$IMAGE/data.ext4"
}

# Slot b stays empty until the first update. Both slots have room for a system that is half as large again.
make_disk() {
    local disk=$IMAGE/kingyo.img.new root_size at=1
    root_size=$((($(stat -c %s "$IMAGE/root.sqfs") + 1048575) / 1048576))
    slot_size=${slot_size:-$((root_size * 3 / 2))}
    check_slot slot_size "$slot_size" "$root_size" || return 1
    rm -f "$disk"
    truncate -s $((boot_size + 2 * slot_size + 1 + data_size + 2))M "$disk"
    sfdisk -q "$disk" <<END
label: gpt
start=${at}M, size=${boot_size}M, type=uefi, name=kingyo-boot
start=$((at + boot_size))M, size=${slot_size}M, type=linux, name=kingyo-root-a, attrs=60
start=$((at + boot_size + slot_size))M, size=${slot_size}M, type=linux, name=kingyo-root-b, attrs=60
start=$((at + boot_size + 2 * slot_size))M, size=1M, type=linux, name=kingyo-slots
start=$((at + boot_size + 2 * slot_size + 1))M, size=${data_size}M, type=linux, name=kingyo-data
END
    put "$IMAGE/boot.fat" $at
    put "$IMAGE/root.sqfs" $((at + boot_size))
    put "$IMAGE/slots" $((at + boot_size + 2 * slot_size))
    put "$IMAGE/data.ext4" $((at + boot_size + 2 * slot_size + 1))
    mv "$disk" "$IMAGE/kingyo.img"
    rm -f "$IMAGE/boot.fat" "$IMAGE/slots" "$IMAGE/data.ext4"
}

needs
mkdir -p "$IMAGE"
"$here/root.sh" "$board"
"$here/boot.sh" "$board"
step "the stall, onto a root that cannot be written"
make_root
make_data
make_slots
step "the disk"
make_disk
printf '%s/kingyo.img: %d MiB, of which root %d; %s s\n' "$IMAGE" "$(($(stat -c %s "$IMAGE/kingyo.img") >> 20))" \
    "$(($(stat -c %s "$IMAGE/root.sqfs") >> 20))" "$SECONDS"
