#!/bin/bash
# card.sh BOARD -- makes the memory card of board/BOARD/image.conf for a Raspberry Pi, with the kiosk of $BUILD:
# $IMAGE/kingyo-VERSION-BOARD.img.xz, its checksum and the list of its packages.
#
# fetch.sh downloads Debian's packages, root.sh unpacks them, boot.sh makes the boot partition, and this script installs
# the kiosk and writes the card. Two builds of one tree with the same downloads give the same bytes.
# Exit code 1: something is missing or failed; one line says what. Exit code 2: wrong usage.
# shellcheck disable=SC2154,SC1091,SC2115  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
. "$here/card/lib.sh"
. "$here/system.sh"

# Unpacks the Debian packages of this tree. Their service is started by a link.
install_kiosk() { # FOLDER
    local root=$1 deb
    for deb in "$BUILD"/deb/kingyo_*_"$arch".deb "$BUILD"/deb/kingyo-kiosk_*.deb; do
        dpkg-deb --fsys-tarfile "$deb" | tar -x --keep-directory-symlink -C "$root"
    done
    SOURCE_DATE_EPOCH=$made_s "$here/card/configure.sh" "$root" >"$IMAGE/configure.log" 2>&1 || {
        tail -5 "$IMAGE/configure.log" >&2
        return 1
    }
    mkdir -p "$root/etc/systemd/system/multi-user.target.wants"
    ln -s /usr/lib/systemd/system/kingyo.service "$root/etc/systemd/system/multi-user.target.wants/"
}

# Adds what only the card has: its own units, the names of the header's lines, and its partition.
settle_board() { # FOLDER
    local root=$1
    cp -r "$top/board/$board/root/." "$root/"
    cat "$top/board/$board/lines.conf" >>"$root/etc/kingyo/kingyo.conf"
    sed -i "s/^PARTLABEL=kingyo-data /PARTUUID=$disk_id-04 /" "$root/etc/fstab"
    grep -q "^PARTUUID=$disk_id-04 " "$root/etc/fstab"
    # Of the programs that make units at each start, only the one for fstab is needed. Each costs time.
    find "$root/usr/lib/systemd/system-generators" -mindepth 1 ! -name systemd-fstab-generator -delete
    rm -rf "$root/var/lib/systemd/catalog"
}

# Makes the data partition: empty, and owned by the kiosk. Room in its tables lets it grow to 256 GiB. mkfs.ext4 uses only
# the last -E.
make_data() {
    rm -f "$IMAGE/data.ext4"
    truncate -s "${data_size}M" "$IMAGE/data.ext4"
    SOURCE_DATE_EPOCH=$made_s E2FSPROGS_FAKE_TIME=$made_s mkfs.ext4 -q -F -L kingyo-data -m 0 -b 4096 -i 16384 -J size=16 \
        -U 6b696e67-796f-4000-8000-000000000004 \
        -E "hash_seed=6b696e67-796f-4000-8000-000000000005,resize=67108864,root_owner=$kiosk_owner,lazy_itable_init=0,lazy_journal_init=0" \
        "$IMAGE/data.ext4"
}

# Makes the disk of a system that is only an initramfs: the boot partition.
make_boot_disk() {
    local disk=$IMAGE/kingyo.img.new
    rm -f "$disk"
    truncate -s $((boot_at + boot_size))M "$disk"
    partitions | sfdisk -q "$disk"
    put "$IMAGE/boot.fat" "$boot_at"
    mv "$disk" "$IMAGE/kingyo.img"
    rm -f "$IMAGE/boot.fat"
}

make_disk() {
    local disk=$IMAGE/kingyo.img.new size
    size=$((($(stat -c %s "$IMAGE/root.sqfs") + 1048575) / 1048576))
    check_slot root_size "$root_size" "$size" || return 1
    rm -f "$disk"
    truncate -s $((data_at + data_size + 1))M "$disk"
    partitions | sfdisk -q "$disk"
    put "$IMAGE/boot.fat" "$boot_at"
    put "$IMAGE/slots" "$slots_at"
    put "$IMAGE/root.sqfs" "$root_at"
    put "$IMAGE/data.ext4" "$data_at"
    mv "$disk" "$IMAGE/kingyo.img"
    rm -f "$IMAGE/boot.fat" "$IMAGE/slots" "$IMAGE/data.ext4"
}

# Writes the files that a user downloads: the compressed image, its checksum, and the list of Debian's packages in it.
# The number of threads is fixed, because it determines the bytes.
make_release() {
    local name=kingyo-$version-$board
    xz -T2 -2 -c "$IMAGE/kingyo.img" >"$IMAGE/$name.img.xz.new"
    mv "$IMAGE/$name.img.xz.new" "$IMAGE/$name.img.xz"
    cp "$cache/packages.list" "$IMAGE/$name.packages"
    (cd "$IMAGE" && sha256sum "$name.img.xz" >"$name.img.xz.sha256")
    printf '%s/%s.img.xz: %d MiB, %d s\n' "$IMAGE" "$name" "$(($(stat -c %s "$IMAGE/$name.img.xz") >> 20))" "$SECONDS"
}

main() {
    needs_tools
    mkdir -p "$IMAGE"
    "$here/card/fetch.sh" "$board"
    "$here/card/root.sh" "$board"
    "$here/card/boot.sh" "$board"
    if [ "$layout" = initramfs ]; then
        make_boot_disk
    else
        step "the kiosk, on a root that cannot be written"
        make_root
        make_data
        make_slots
        step "the card"
        make_disk
        printf '%s/kingyo.img: %d MiB, of which root %d; %s s\n' "$IMAGE" "$(($(stat -c %s "$IMAGE/kingyo.img") >> 20))" \
            "$(($(stat -c %s "$IMAGE/root.sqfs") >> 20))" "$SECONDS"
    fi
    [ "${COMPRESS:-yes}" = no ] || make_release # tests/vm/board/repeat.sh compares the image itself.
}

main
