#!/bin/bash
# root.sh BOARD -- unpacks Debian's packages for the card in $cache/root.tar (configure.sh does the work of their scripts),
# and the packages that are used beside the root: the kernel, busybox, and the firmware. Asks no mirror (fetch.sh did).
# shellcheck disable=SC2154,SC1091,SC2115  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
. "$here/card/lib.sh"

# The newest change of a package is the time of every file, so that two roots of the same packages are equal.
SOURCE_DATE_EPOCH=$(stat -c %Y "$cache"/debs/*.deb | sort -n | tail -1)
export SOURCE_DATE_EPOCH
made_of="$(cksum <"$cache/packages.list") $(root_packages)"

make_root_tar() {
    [ "$(cat "$cache/root.tar.of" 2>/dev/null)" = "$made_of" ] && return
    step "unpacks Debian's packages: $suite, $arch"
    mmdebstrap --quiet --mode=root --format=tar --variant=extract --architectures="$arch" \
        --include='?essential' --include="$(root_packages)" --skip=check/qemu --aptopt='APT::Install-Recommends "false"' \
        --dpkgopt='path-exclude=/usr/share/man/*' \
        --dpkgopt='path-exclude=/usr/share/doc/*' --dpkgopt='path-exclude=/usr/share/locale/*' \
        "$suite" "$cache/root.tar.new" "deb [trusted=yes] copy:$cache/debs ./" >"$cache/root.log" 2>&1 || {
        why=$(grep -E '^(E|W): ' "$cache/root.log" | head -1)
        echo "image: Debian's packages could not be unpacked: ${why:-$(tail -1 "$cache/root.log")} (see $cache/root.log)" >&2
        exit 1
    }
    mv "$cache/root.tar.new" "$cache/root.tar"
    echo "$made_of" >"$cache/root.tar.of"
}

unpack_kernel() {
    local release deb
    [ "$(cat "$kernel_root/made_of" 2>/dev/null)" = "$made_of" ] && return
    rm -rf "$kernel_root"
    mkdir -p "$kernel_root"
    for deb in "$cache"/debs/linux-image-*.deb $(printf "$cache/debs/%s_*.deb " $boot_packages); do
        dpkg-deb --fsys-tarfile "$deb" | tar -x -C "$kernel_root"
    done
    # Modules are in /lib, or in /usr/lib from Debian 13 on.
    [ -d "$kernel_root/lib/modules" ] || { mkdir -p "$kernel_root/lib"; mv "$kernel_root/usr/lib/modules" "$kernel_root/lib/"; }
    release=$(basename "$kernel_root"/lib/modules/*)
    depmod -b "$kernel_root" "$release"
    echo "$release" >"$kernel_root/release"
    echo "$made_of" >"$kernel_root/made_of"
}

[ "$layout" = initramfs ] || make_root_tar
unpack_kernel
