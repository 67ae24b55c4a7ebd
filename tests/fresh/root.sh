# root.sh -- a root file system in a temporary folder, for the tests of packages. Source the file in the root of the
# repository. It adds $root to tests/lib.sh. The root is removed when the script ends.
# shellcheck shell=bash disable=SC2154,SC1091,SC2034  # lib.sh sets variables, and the sourcing scripts use others
export TMPDIR=/var/tmp # A root has some hundred megabytes.
. tests/lib.sh
unset XDG_DATA_HOME TMPDIR # The programs in the root use its own folders.
exec </dev/null
build=$(realpath "$build")
root=$work/root
finish() {
    mountpoint -q "$root/proc" && umount "$root/proc"
    rm -rf --one-file-system "$work"
}
trap finish EXIT
mkdir -p "$root" "$build/fresh"

# The libraries of the programs in Debian 13.
libraries=libsdl2-2.0-0,libgles2,libegl1,libgl1-mesa-dri,libusb-1.0-0,libgpiod3,libsqlite3-0

# Unpacks a minimal root with systemd and PACKAGES. The root is made once a week, in BUILD/fresh/NAME.tar. systemd-tmpfiles
# reaches files through /proc.
make_root() { # NAME RELEASE ARCH PACKAGES, the last of them separated by commas
    local tar=$build/fresh/$1.tar sources
    if [ -z "$(find "$tar" -mtime -7 2>/dev/null)" ]; then
        sources=$(board/debian_sources.sh "$2" "test-$1") || return 1
        mapfile -t sources <<<"$sources"
        # mmdebstrap cannot see that the emulator works without the package arch-test.
        mmdebstrap --quiet --format=tar --variant=minbase --aptopt='APT::Install-Recommends "false"' --architectures="$3" \
            --skip=check/qemu --include="systemd,udev,init-system-helpers${4:+,$4}" "$2" "$tar.new" "${sources[@]}" || return 1
        mv "$tar.new" "$tar"
    fi
    tar -C "$root" -xf "$tar" --exclude='./dev/*' && mount -t proc proc "$root/proc"
}
