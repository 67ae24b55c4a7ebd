#!/bin/bash
# initrd.sh -- the initial RAM disk of the guest, in $cache/initrd.zst: busybox, its script and the
# required modules.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"

kernel=$cache/kernel release=$(cat "$cache/kernel/release")
[ "$cache/initrd.zst" -nt "$kernel/release" ] && [ "$cache/initrd.zst" -nt "$here/guest/initramfs" ] &&
    [ "$cache/initrd.zst" -nt "$0" ] && exit 0
step 'initramfs'
modules='virtio_pci virtio_mmio virtio_blk squashfs overlay 9p 9pnet_virtio configfs gpio-sim dummy_hcd
    libcomposite usb_f_hid usbhid hid-generic virtio-gpu i6300esb snd-dummy evdev'
image=$cache/initrd
rm -rf "$image"
mkdir -p "$image"/{bin,proc,sys,dev,new,lower,upper,lib/modules/"$release"}
cp "$cache/busybox" "$image/bin/busybox"
install "$here/guest/initramfs" "$image/init"
cp "$kernel/lib/modules/$release"/modules.builtin{,.modinfo} "$kernel/lib/modules/$release/modules.order" "$image/lib/modules/$release/"
copy_modules "$kernel" "$release" "$image" "$modules"
(cd "$image" && find . | cpio -o -H newc --quiet) | zstd -q -f -3 -o "$cache/initrd.zst"
rm -rf "$image"
