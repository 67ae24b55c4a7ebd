#!/bin/bash
# boot.sh BOARD -- makes the boot partition of a Raspberry Pi: firmware, kernel, initramfs, device trees.
#
# The firmware reads config.txt, loads kernel and initramfs, and selects the device tree of the board. Debian's kernel
# cannot apply overlays, and Debian's firmware package has none of ours. Therefore the overlays are applied here.
# shellcheck disable=SC2154,SC1091,SC2115  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
. "$here/card/lib.sh"

release=$(cat "$kernel_root/release")

# Adds the files of a card: its partitions are found by the number of the disk. The initramfs of a poi is its whole system:
# its program, its script and its default settings.
fill_initrd() { # FOLDER
    if [ "$layout" = initramfs ]; then
        install "$top/board/$board/init" "$1/init"
        install "$BUILD/cross/$arch/root/kingyo/build/kingyo-poi" "$top/board/poi-gadget/kingyo-poi-gadget" "$1/bin/"
        install -D -m 644 "$top"/board/poi-gadget/{poi,gadget}.conf -t "$1/etc/kingyo-poi/"
    else
        install -m 644 "$here/card/disk.sh" "$1/disk.sh"
    fi
    echo "$disk_id" >"$1/disk_id"
}

# Prints config.txt. The file names nothing that is not on the card.
raspi_config() {
    cat <<END
# config.txt -- settings of the firmware, made by \`make image BOARD=$board\`.
arm_64bit=1
upstream_kernel=1
kernel=linux
initramfs initrd followkernel
disable_overscan=1
disable_splash=1
END
    # The pins from power on are those of the board's page.
    [ ! -f "$top/board/$board/config.txt" ] || sed -n '/^# State of the pins/,/^gpio=16/p' "$top/board/$board/config.txt"
}

# Writes the device tree of each board, with the overlays. Labels that the overlays expect and the tree lacks are added.
raspi_device_trees() { # FOLDER
    local name from label overlay
    local -a compiled=()
    from=$(echo "$kernel_root"/usr/lib/linux-image-*/broadcom)
    for overlay in $overlays; do
        compiled+=("$IMAGE/overlay-${#compiled[@]}")
        dtc -q -@ -I dts -O dtb -o "${compiled[-1]}" "$top/board/$overlay"
    done
    for name in $dtbs; do
        cp "$from/$name.dtb" "$IMAGE/tree"
        for label in ${symbols:-}; do
            fdtput "$IMAGE/tree" /__symbols__ "${label%%=*}" -ts "${label#*=}"
        done
        fdtoverlay -i "$IMAGE/tree" -o "$1/$name.dtb" "${compiled[@]}"
    done
    rm "$IMAGE/tree" "${compiled[@]}"
}

make_boot() {
    local fat=$IMAGE/boot.fat folder=$IMAGE/boot firmware=$kernel_root/usr/lib/raspi-firmware file
    rm -rf "$fat" "$folder"
    mkdir "$folder"
    cp "$firmware"/{bootcode.bin,start.elf,fixup.dat,start4.elf,fixup4.dat} "$folder/"
    cp "$kernel_root/usr/share/doc/raspi-firmware/copyright" "$folder/LICENCE.txt"
    cp "$kernel_root/boot/vmlinuz-$release" "$folder/linux"
    cp "$IMAGE/initrd.zst" "$folder/initrd"
    raspi_device_trees "$folder"
    for file in ${boot_files:-}; do
        cp "$top/board/$file" "$folder/"
    done
    # The inertial sensor for which Debian's kernel has a driver (board/poi/mpu6050.dts).
    [ ! -f "$folder/poi.conf" ] || sed -i 's/^imu = bno055 /imu = mpu6050/' "$folder/poi.conf"
    raspi_config >"$folder/config.txt"
    echo "$boot_words" >"$folder/cmdline.txt"
    find "$folder" -exec touch -h -d "@$made_s" {} +
    truncate -s "${boot_size}M" "$fat"
    mkfs.vfat -F 32 -n KINGYO -i "$disk_id" --invariant "$fat" >/dev/null
    for file in "$folder"/*; do # The shell sorts the names, so two partitions have the same order.
        TZ=UTC mcopy -m -i "$fat" "$file" ::/
    done
    rm -rf "$folder"
}

step "the kernel: $release"
make_initrd usr/bin
make_boot
