#!/bin/bash
# cross.sh ARCH TARGET -- runs `make TARGET` for another processor (arm64 or armhf) in a root of Debian 13.
#
# The root contains the cross compiler and the libraries of both processors. It is made once a week in
# BUILD/cross/ARCH/root. The tree is copied to /kingyo in the root, and its results are in /kingyo/build there. Programs
# for ARCH run in the root by qemu's emulation of user programs. Needs root and this machine's mirror. Exits with 1 if the
# root cannot be made, or with the exit code of make.
set -eu
cd "$(dirname "$0")/../.."
arch=${1:?usage: cross.sh ARCH TARGET} target=${2:?usage: cross.sh ARCH TARGET}
suite=trixie
. board/refuse_shared.sh
mkdir -p "${BUILD:-build}/cross"
refuse_shared cross "${BUILD:-build}/cross"
board/deb/emulate.sh "$arch"
triplet=aarch64-linux-gnu
[ "$arch" = arm64 ] || triplet=arm-linux-gnueabihf
folder=${BUILD:-build}/cross/$arch
mkdir -p "$folder"
refuse_shared cross "$folder"
folder=$(cd "$folder" && pwd)
root=$folder/root

# Prints the packages of board/packages.txt that the build and the unit tests need: tools of this machine, and libraries
# of the processor ARCH.
packages() {
    awk -v arch="$arch" '!/^#/ && ($2 == "run" || $1 == "libcmocka-dev" || $1 == "libassimp-dev") {
        is_library = $1 ~ /^lib/ && $1 != "libstb-dev" && $1 != "libc6-dev"
        print $1 (is_library ? ":" arch : "") }' board/packages.txt
    printf '%s\n' make dpkg-dev "crossbuild-essential-$arch"
}

release_root() {
    local part
    for part in dev/pts dev proc; do
        mountpoint -q "$root/$part" && umount "$root/$part"
    done
    return 0
}
trap release_root EXIT

make_root() {
    local wanted sources
    wanted=$(packages | sort | tr '\n' ' ')
    if [ -n "$(find "$folder/packages" -mtime -7 2>/dev/null)" ] && [ "$(cat "$folder/packages")" = "$wanted" ]; then
        return
    fi
    sources=$(board/debian_sources.sh "$suite" cross)
    mapfile -t sources <<<"$sources"
    echo "cross: a root of Debian 13 with the compiler for $arch, in about two minutes"
    release_root
    rm -rf --one-file-system "$root"
    mmdebstrap --quiet --mode=root --variant=minbase --architectures="$(dpkg --print-architecture),$arch" \
        --include="$(packages | tr '\n' ',')" --aptopt='APT::Install-Recommends "false"' \
        "$suite" "$root" "${sources[@]}" >"$folder/root.log" 2>&1 || {
        grep -E '^E: ' "$folder/root.log" | head -1 | sed 's/^/cross: /' >&2
        echo "cross: the root could not be made; see $folder/root.log" >&2
        return 1
    }
    echo "$wanted" >"$folder/packages"
}

# Replaces the tree in the root by the files of this tree. The results of earlier runs stay.
copy_tree() {
    mkdir -p "$root/kingyo"
    find "$root/kingyo" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
    git ls-files -co --exclude-standard -z | tar cf - --ignore-failed-read --null -T - | tar xf - -C "$root/kingyo"
}

# Runs make in the root. Emulated tests need about twenty times as long, so they get a longer limit.
make_inside() { # TARGET
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root TERM=dumb LC_ALL=C.UTF-8 \
        PKG_CONFIG_LIBDIR="/usr/lib/$triplet/pkgconfig:/usr/share/pkgconfig" TEST_LIMIT_S=3000 \
        DEB_HOST_ARCH="$arch" STRIP="$triplet-strip" VERSION="${VERSION:-}" \
        SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || stat -c %Y core/core.h)}" \
        chroot "$root" make -C /kingyo --no-print-directory -j"$(nproc)" CC="$triplet-gcc" LD="$triplet-ld" \
        AR="$triplet-ar" NM="$triplet-nm" OBJCOPY="$triplet-objcopy" BUILD_CC=gcc ONLY="${ONLY:-}" "$1"
}

make_root
copy_tree
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
make_inside "$target"
if [ "$target" = deb ]; then
    mkdir -p "${BUILD:-build}/deb"
    cp "$root"/kingyo/build/deb/*.deb "${BUILD:-build}/deb/"
    ls "${BUILD:-build}"/deb/*_"$arch".deb
fi
