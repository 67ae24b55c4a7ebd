#!/bin/bash
# boot.sh BOARD -- makes the boot files in $IMAGE: the kernel, the initramfs, and the partition with both.
# shellcheck disable=SC2154,SC1091,SC2115  # lib.sh sets them
. "$(dirname "$0")/lib.sh"

release=$(cat "$kernel_root/release")

# For UEFI: systemd's boot loader, without a menu and without an editor for kernel parameters.
make_boot() {
    local fat=$IMAGE/boot.fat
    rm -f "$fat"
    truncate -s "${boot_size}M" "$fat"
    mkfs.vfat -F 32 -n KINGYO "$fat" >/dev/null
    printf 'timeout 0\neditor no\ndefault kingyo.conf\n' >"$IMAGE/loader.conf"
    printf 'title Kingyo\nlinux /kingyo/linux\ninitrd /kingyo/initrd\noptions %s\n' "$boot_words" >"$IMAGE/entry.conf"
    mmd -i "$fat" ::/EFI ::/EFI/BOOT ::/loader ::/loader/entries ::/kingyo
    mcopy -i "$fat" "$kernel_root/usr/lib/systemd/boot/efi/systemd-bootx64.efi" ::/EFI/BOOT/BOOTX64.EFI
    mcopy -i "$fat" "$IMAGE/loader.conf" ::/loader/loader.conf
    mcopy -i "$fat" "$IMAGE/entry.conf" ::/loader/entries/kingyo.conf
    mcopy -i "$fat" "$kernel_root/boot/vmlinuz-$release" ::/kingyo/linux
    mcopy -i "$fat" "$IMAGE/initrd.zst" ::/kingyo/initrd
    rm "$IMAGE/loader.conf" "$IMAGE/entry.conf"
}

step "the kernel: $release"
make_initrd bin
make_boot
echo "$boot_words" >"$IMAGE/kernel_words"
