# card.sh -- the boot files of a card. Source it after lib.sh, with the card's folder in $image.
# QEMU does not run the firmware of a Raspberry Pi. Therefore kernel, initramfs, device tree and kernel parameters are
# read from the boot partition of the card and passed to QEMU, as the firmware would do.
# shellcheck shell=bash disable=SC2154,SC2034  # the sourcing scripts set and use these variables
boot_at=4M

# Copies the boot partition to $boot.
unpack_boot() {
    boot=$cache/boot
    rm -rf "$boot"
    mkdir -p "$boot"
    mcopy -s -i "$image/kingyo.img@@$boot_at" '::*' "$boot/"
}

# Prints the modules that the card's initramfs loads. A second initramfs replaces the list of all modules, so it must
# contain these, too.
card_modules() {
    zstd -dc "$boot/initrd" | cpio -i --quiet --to-stdout boot_modules ./boot_modules
}
