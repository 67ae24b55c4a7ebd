# virt.sh -- the card in QEMU's machine `virt`, which has an AArch64 processor, a disk, a screen and a watchdog, but no part
# of a Raspberry Pi. image/disk.sh sources this file if CARD is set.
# shellcheck shell=bash disable=SC2154,SC2034,SC1091  # image/disk.sh sets and uses these variables
. "$here/board/card.sh"
unpack_boot
kernel_image=$boot/linux image_initrd=$boot/initrd image_words=$boot/cmdline.txt
programs=$BUILD/cross/$arch/root/kingyo/build
busybox=$BUILD/image/$suite-$arch/kernel/usr/bin/busybox
shaders=$modules_cache/mesa
test_modules="$test_modules virtio_rng i6300esb ext4"
late_modules=virtio_gpu # The screen's driver comes after all other parts, as on a board (kingyo-test-screen.service).
test_words=console=ttyAMA0

machine_words() {
    printf '%s\n' -machine virt -cpu cortex-a72
}
