#!/bin/bash
# root.sh -- the root file system of the guest, in $cache/root.sqfs, with packages of Debian only.
# Our own files come through the shared folder, so that a change of the kiosk does not require a
# new root.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"

is_fresh "$cache/root.sqfs" && exit 0
step "a root to boot: $suite, $arch"
unpack_root "$cache/root" "$arch" "busybox-static,dash,base-files,libsdl2-2.0-0,libgl1-mesa-dri,libgles2,\
libegl1,libgbm1,libusb-1.0-0,$gpiod,gpiod,libsqlite3-0,udev,usbutils,kmod,procps,libgcc-s1"
settle_root "$cache/root"
rm -rf "$cache"/root/usr/share/{doc,man,locale,info,icons} "$cache/root/var/lib/apt" \
    "$cache/root/var/cache"
cp "$cache/root/usr/bin/busybox" "$cache/busybox"
mksquashfs "$cache/root" "$cache/root.new" -comp lz4 -noappend -no-progress -quiet >/dev/null
mv "$cache/root.new" "$cache/root.sqfs"
rm -rf --one-file-system "$cache/root"
