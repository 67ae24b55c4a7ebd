#!/bin/bash
# root.sh BOARD -- installs Debian's packages for the disk (packages.txt) in $cache, and unpacks its kernel.
# shellcheck disable=SC2154,SC1091,SC2115  # lib.sh sets them
. "$(dirname "$0")/lib.sh"

packages=$(awk '!/^#/ && NF { printf "%s%s", comma, $1; comma = "," }' "$here/packages.txt")
made_of="$suite $arch $kernel $packages"
is_fresh "$cache/root.tar" "$made_of" && exit 0
step "Debian's packages: $suite, $arch"
sources=$("$top/board/debian_sources.sh" "$suite" image)
mapfile -t lines <<<"$sources"
rm -rf "$cache/debs"
mkdir -p "$cache/debs"
# The same apt fetches the kernel, so that kernel and packages are of the same day. The kernel is unpacked beside the root
# file system, because an installed kernel requires a tool that makes initramfs files.
export cache kernel
mmdebstrap --quiet --mode=root --format=tar --variant=essential --architectures="$arch" --include="$packages" \
    --aptopt='APT::Install-Recommends "false"' --dpkgopt='path-exclude=/usr/share/man/*' \
    --dpkgopt='path-exclude=/usr/share/doc/*' --dpkgopt='path-exclude=/usr/share/locale/*' \
    --customize-hook='cd "$cache/debs" && export APT_CONFIG="$MMDEBSTRAP_APT_CONFIG" &&
        apt-get -qq download "$(apt-cache depends "$kernel" | sed -n "s/.*Depends: \(linux-image-[^ ]*\)$/\1/p" | head -1)" \
            systemd-boot-efi busybox-static' \
    "$suite" "$cache/root.tar.new" "${lines[@]}" >"$cache/root.log" 2>&1 || {
    why=$(grep -E '^(E|W): ' "$cache/root.log" | head -1)
    why="Debian's packages could not be had: ${why:-$(tail -1 "$cache/root.log")} (all of it: $cache/root.log)"
    if [ "$(cat "$cache/root.tar.of" 2>/dev/null)" = "$made_of" ]; then
        echo "image: $why; those of $(date -r "$cache/root.tar" +%F) are taken again" >&2
        exit 0
    fi
    echo "image: $why" >&2
    exit 1
}
rm -rf "$kernel_root"
mkdir -p "$kernel_root"
for deb in "$cache"/debs/*.deb; do
    dpkg-deb --fsys-tarfile "$deb" | tar -x -C "$kernel_root"
done
# Modules are in /lib, or in /usr/lib from Debian 13 on.
[ -d "$kernel_root/lib/modules" ] || { mkdir -p "$kernel_root/lib"; mv "$kernel_root/usr/lib/modules" "$kernel_root/lib/"; }
release=$(basename "$kernel_root"/lib/modules/*)
depmod -b "$kernel_root" "$release"
echo "$release" >"$kernel_root/release"
rm -rf "$cache/debs"
mv "$cache/root.tar.new" "$cache/root.tar"
echo "$made_of" >"$cache/root.tar.of"
