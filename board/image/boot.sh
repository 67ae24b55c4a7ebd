#!/bin/bash
# boot.sh BOARD -- makes the boot files in $IMAGE: the kernel, the initramfs, and the partition with both.
# shellcheck disable=SC2154,SC1091,SC2115  # lib.sh sets them
. "$(dirname "$0")/lib.sh"

release=$(cat "$kernel_root/release")
# The root partition is read-only, the boot loader accepts no kernel parameters, and a crashed kernel restarts after 5 s.
# fsck answers its own questions with yes, because no operator is present.
words="quiet fsck.repair=yes loglevel=3 panic=5 oops=panic systemd.getty_auto=0 systemd.gpt_auto=0 vt.global_cursor_default=0 $kernel_words"

# Makes the folder that the initramfs mounts over the modules of each system. The modules for USB disks lie in a tree of
# their own, so that udev cannot load them: only the update page does (modprobe --dirname).
make_kernel_modules() { # FOLDER
    mkdir -p "$1"
    install_modules "$1" "$boot_modules $modules"
    mv "$1/usr/lib/modules/$release" "$1/$release"
    rm -r "$1/usr" "$1/lib"
    install_modules "$1/usb-disk" "$usb_disk_modules"
}

make_initrd() {
    local image=$IMAGE/initrd
    rm -rf "$image"
    mkdir -p "$image/bin"
    cp "$kernel_root/bin/busybox" "$image/bin/busybox"
    install "$here/initramfs" "$image/init"
    install -m 644 "$here/slots/slots.sh" "$image/slots.sh"
    echo "$boot_modules" >"$image/boot_modules"
    install_modules "$image" "$boot_modules"
    make_kernel_modules "$image/kernel-modules"
    find "$image" -exec touch -h -d "@$made_s" {} +
    (cd "$image" && find . | sort | cpio -o -H newc --quiet --reproducible -R 0:0) | zstd -q -f -9 -o "$IMAGE/initrd.zst"
    rm -rf "$image"
}

# For UEFI: systemd's boot loader, without a menu and without an editor for kernel parameters.
make_boot() {
    local fat=$IMAGE/boot.fat
    rm -f "$fat"
    truncate -s "${boot_size}M" "$fat"
    mkfs.vfat -F 32 -n KINGYO "$fat" >/dev/null
    printf 'timeout 0\neditor no\ndefault kingyo.conf\n' >"$IMAGE/loader.conf"
    printf 'title Kingyo\nlinux /kingyo/linux\ninitrd /kingyo/initrd\noptions %s\n' "$words" >"$IMAGE/entry.conf"
    mmd -i "$fat" ::/EFI ::/EFI/BOOT ::/loader ::/loader/entries ::/kingyo
    mcopy -i "$fat" "$kernel_root/usr/lib/systemd/boot/efi/systemd-bootx64.efi" ::/EFI/BOOT/BOOTX64.EFI
    mcopy -i "$fat" "$IMAGE/loader.conf" ::/loader/loader.conf
    mcopy -i "$fat" "$IMAGE/entry.conf" ::/loader/entries/kingyo.conf
    mcopy -i "$fat" "$kernel_root/boot/vmlinuz-$release" ::/kingyo/linux
    mcopy -i "$fat" "$IMAGE/initrd.zst" ::/kingyo/initrd
    rm "$IMAGE/loader.conf" "$IMAGE/entry.conf"
}

step "the kernel: $release"
make_initrd
make_boot
echo "$words" >"$IMAGE/kernel_words"
