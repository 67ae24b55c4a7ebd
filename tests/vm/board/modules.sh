#!/bin/bash
# modules.sh -- the drivers that only the emulated boards need, in BUILD/vm/card/kernel beside the modules of the card's own
# kernel: simulated lines (gpio-sim) and a picture on a plain frame buffer (simpledrm).
# Debian's kernel leaves both out. They are compiled from Debian's kernel source in the root of `make deb ARCH=arm64`.
# shellcheck disable=SC2154,SC1091,SC2034  # lib.sh sets and uses these variables
GUEST=card
. "$(dirname "$0")/../lib.sh"

card=$(cd "$BUILD/image/$suite-$arch/kernel" && pwd)
release=$(cat "$card/release")
builder=$(cd "$BUILD/cross/$arch/root" && pwd)
kernel=$cache/kernel debs=$cache/debs
made_of="$release $(cat "$0" "$here"/modules/*.c | cksum)"
[ "$(cat "$kernel/made_of" 2>/dev/null)" = "$made_of" ] && exit 0

# Unpacks the headers of the kernel into the builder, and the sources of the drivers into a folder.
fetch() {
    local source=linux-source-$linux
    mkdir -p "$debs"
    (cd "$debs" && guest_apt apt-get -qq download "linux-headers-$release" "linux-headers-${release%"-$arch"}-common" \
        "linux-kbuild-${release%"-$arch"}:amd64" "$source") || {
        echo "test-board: the mirror has no headers of the kernel $release; remove $BUILD/image/$suite-$arch and make the image again" >&2
        return 1
    }
    for deb in "$debs"/linux-headers-*.deb "$debs"/linux-kbuild-*.deb; do
        dpkg-deb --fsys-tarfile "$deb" | tar -x --keep-directory-symlink -C "$builder"
    done
    ( # tar stops at the last file, so the programs before it end with a write error.
        set +o pipefail
        dpkg-deb --fsys-tarfile "$debs/$source"_*.deb 2>/dev/null | tar -xO "./usr/src/$source.tar.xz" 2>/dev/null |
            xz -dc -T0 2>/dev/null | tar -x -C "$builder/modules" --transform='s,.*/,,' --occurrence=1 \
            "$source"/{drivers/gpio/gpio-sim.c,drivers/gpio/gpiolib.h,drivers/gpu/drm/tiny/simpledrm.c,kernel/irq/irq_sim.c}
    )
}

# The kernel's own simplefb has the name and the compatible string of simpledrm, so simpledrm gets others.
compile() {
    local module
    cp "$here"/modules/*.c "$builder/modules/"
    sed -i 's/"simple-framebuffer"/"kingyo,simpledrm"/; s/^#define DRIVER_NAME.*/#define DRIVER_NAME "kingyo-simpledrm"/' \
        "$builder/modules/simpledrm.c"
    printf 'obj-m := irq-sim.o gpio-sim.o simpledrm.o\ngpio-sim-y := gpio-sim-held.o\n' >"$builder/modules/Kbuild"
    mountpoint -q "$builder/proc" || mount -t proc proc "$builder/proc"
    chroot "$builder" env PATH=/usr/bin:/bin make -s -C "/usr/src/linux-headers-$release" M=/modules ARCH="$arch" \
        CROSS_COMPILE="$cross" CONFIG_DEBUG_INFO_BTF_MODULES= modules >"$cache/modules.log" 2>&1 || { tail -20 "$cache/modules.log" >&2; return 1; }
    for module in irq-sim gpio-sim simpledrm; do
        chroot "$builder" "${cross}strip" --strip-debug -o "/modules/$module.stripped" "/modules/$module.ko"
        cp "$builder/modules/$module.stripped" "$kernel/lib/modules/$release/extra/$module.ko"
    done
}

step "drivers for the emulated boards, kernel $release"
rm -rf "$kernel" "$debs" "$builder/modules"
mkdir -p "$kernel/lib/modules/$release/extra" "$builder/modules"
cp -r "$card/lib/modules/$release/." "$kernel/lib/modules/$release/"
fetch
compile
depmod -b "$kernel" "$release"
rm -rf "$debs"
echo "$release" >"$kernel/release"
echo "$made_of" >"$kernel/made_of"
