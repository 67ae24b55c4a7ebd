#!/bin/bash
# kernel.sh -- Debian's own kernel for the guest, and the modules that Debian does not build, in
# $cache/kernel.
# Debian's configurations (6.1 and 6.12) disable gpio-sim. The script builds gpio-sim from Debian's
# kernel source against Debian's headers. It uses only a chroot of this machine.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"

# A disk image is booted with this kernel, so that the kernel must be that of the image. Debian may publish a kernel between
# the two downloads. IMAGE_KERNEL is the file with the release of the image's kernel.
if [ -n "${IMAGE_KERNEL:-}" ]; then
    release=$(cat "$IMAGE_KERNEL")
    guest_apt apt-cache show "linux-headers-$release" >/dev/null 2>&1 || rm -f "$cache/apt/updated"
else
    release=$(kernel_release)
fi
[ -n "$release" ] || { echo "test-vm: no linux-image-$arch in $suite" >&2; exit 1; }
kernel=$cache/kernel
made_of="$release $(cat "$0" "$here"/modules/*.c | cksum)"
[ "$(cat "$kernel/made_of" 2>/dev/null)" = "$made_of" ] && exit 0
step "kernel $release"
rm -rf "$kernel" "$cache/debs"
mkdir -p "$kernel" "$cache/debs"
common=linux-headers-${release%"-$arch"}-common
(cd "$cache/debs" && guest_apt apt-get -qq download "linux-image-$release" "linux-headers-$release" \
    "$common" "linux-source-$linux" 2>/dev/null) || {
    echo "test-vm: Debian has no packages of the kernel $release; remove ${IMAGE_KERNEL:+$(dirname "$(dirname "$IMAGE_KERNEL")") and }$cache/apt, and run the test again" >&2
    exit 1
}
dpkg-deb --fsys-tarfile "$cache"/debs/linux-image-*.deb | tar -x -C "$kernel"
settle_modules() { # The modules are in /lib or, from Debian 13 on, in /usr/lib.
    [ -d "$kernel/lib/modules" ] || { mkdir -p "$kernel/lib"; mv "$kernel/usr/lib/modules" "$kernel/lib/"; }
    depmod -b "$kernel" "$release"
}
settle_modules

# Extracts the kernel without its decompressor, which takes seconds on an emulated machine.
unpack_image() {
    local image=$kernel/boot/vmlinuz-$release offset
    if [ "$arch" = amd64 ]; then
        for packer in xz:$'\xfd7zXZ' zstd:$'\x28\xb5\x2f\xfd'; do
            for offset in $(LC_ALL=C grep -abo -F "${packer#*:}" "$image" | cut -d: -f1); do
                tail -c "+$((offset + 1))" "$image" | "${packer%%:*}" -dc >"$kernel/image" 2>/dev/null || true
                if [ "$(head -c 4 "$kernel/image" | tr -d '\177')" = ELF ]; then
                    return
                fi
            done
        done
    fi
    cp "$image" "$kernel/image"
}
unpack_image

step 'gpio-sim, out of tree'
builder=$cache/builder
for deb in "$cache"/debs/linux-headers-*.deb; do
    dpkg-deb --fsys-tarfile "$deb" | tar -x --keep-directory-symlink -C "$builder"
done
rm -rf "$builder/modules"
mkdir "$builder/modules"
source=linux-source-$linux
( # The last tar stops at the third file, so the programs before it end with a write error.
    set +o pipefail
    dpkg-deb --fsys-tarfile "$cache"/debs/linux-source-*.deb 2>/dev/null |
        tar -xO "./usr/src/$source.tar.xz" 2>/dev/null | xz -dc -T0 2>/dev/null |
        tar -x -C "$builder/modules" --strip-components=3 --occurrence=1 \
            "$source"/{drivers/gpio/gpio-sim.c,drivers/gpio/gpiolib.h,kernel/irq/irq_sim.c}
)
cp "$here"/modules/*.c "$builder/modules/"
printf 'obj-m := irq-sim.o gpio-sim.o\ngpio-sim-y := gpio-sim-held.o\n' >"$builder/modules/Kbuild"
karch=$([ "$arch" = amd64 ] && echo x86 || echo "$arch")
mkdir -p "$builder/proc"
chroot "$builder" make -s -C "/usr/src/linux-headers-$release" M=/modules ARCH="$karch" \
    CROSS_COMPILE="$cross" modules >"$cache/modules.log" 2>&1 || { tail -20 "$cache/modules.log" >&2; exit 1; }
mkdir -p "$kernel/lib/modules/$release/extra"
for module in irq-sim gpio-sim; do
    "${cross}strip" --strip-debug -o "$kernel/lib/modules/$release/extra/$module.ko" \
        "$builder/modules/$module.ko" 2>/dev/null ||
        cp "$builder/modules/$module.ko" "$kernel/lib/modules/$release/extra/"
done
depmod -b "$kernel" "$release"
rm -rf "$cache/debs"
echo "$release" >"$kernel/release"
echo "$made_of" >"$kernel/made_of"
