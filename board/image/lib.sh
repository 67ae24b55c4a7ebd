# lib.sh -- functions that the scripts of this folder share. Source the file with BOARD as the first argument, and with
# BUILD and IMAGE set.
#
# Downloads are stored in $cache, by release, and are fetched again after a week. Results are stored in $IMAGE.
# shellcheck shell=bash disable=SC2034,SC1091,SC1090,SC2154,SC2115  # the scripts that source this file use the variables
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(cd "$here/../.." && pwd)
board=${1:?usage: BOARD} BUILD=${BUILD:-build}
IMAGE=${IMAGE:-$BUILD/image/$board}
. "$top/board/$board/image.conf"
. "$here/update/drivers.sh"
version=$(sed -n 's/.*define KINGYO_VERSION "\(.*\)".*/\1/p' "$top/core/core.h")
mkdir -p "$IMAGE" "$BUILD/image/$suite-$arch"
IMAGE=$(cd "$IMAGE" && pwd) cache=$(cd "$BUILD/image/$suite-$arch" && pwd)
kernel_root=$cache/kernel
# Kernel parameters of each disk: the root partition is read-only, and a crashed kernel restarts after 5 s. fsck answers its
# own questions with yes, because no operator is present.
boot_words="quiet fsck.repair=yes loglevel=3 panic=5 oops=panic systemd.getty_auto=0 systemd.gpt_auto=0 vt.global_cursor_default=0 $kernel_words"
days_max=7 # Maximum age of a download in days, because mirrors remove old packages.
made_s=$(git -C "$top" log -1 --format=%ct 2>/dev/null || date +%s)
# Public key of minisign for updates, and the number of this version, which rises with each commit.
UPDATE_KEY=${UPDATE_KEY:-} update_version=${UPDATE_VERSION:-$made_s}
update_name="Kingyo $version ($(date -u -d "@$update_version" +%F))"

. "$top/board/refuse_shared.sh"
refuse_shared image "$BUILD/image" "$IMAGE" "$cache"

step() { printf '[%4d s] image: %s\n' "$SECONDS" "$*"; }

needs() {
    local tool
    [ -z "$UPDATE_KEY" ] || grep -qs '^RW' "$UPDATE_KEY" || { echo "image: $UPDATE_KEY is no public key of minisign" >&2; exit 1; }
    if [ "$(id -u)" -ne 0 ]; then
        echo 'image: a root file system is made by root; please run: sudo make image' >&2
        exit 1
    fi
    for tool in mmdebstrap mksquashfs sfdisk mkfs.ext4 mkfs.vfat mcopy cpio zstd depmod systemd-sysusers; do
        command -v "$tool" >/dev/null || {
            echo "image: $tool is not installed; board/setup.sh vm installs what is needed" >&2
            exit 1
        }
    done
}

# Succeeds if FILE is younger than days_max days and was made from the same WORDS.
is_fresh() { # FILE WORDS
    [ -n "$(find "$1" -maxdepth 0 -mtime "-$days_max" 2>/dev/null)" ] && [ "$(cat "$1.of" 2>/dev/null)" = "$2" ]
}

# Copies the named kernel modules, and the modules they need, below FOLDER.
install_modules() { # FOLDER MODULES
    local release module file to
    release=$(cat "$kernel_root/release")
    mkdir -p "$1/usr/lib/modules/$release"
    cp "$kernel_root/lib/modules/$release"/modules.{builtin,builtin.modinfo,order} "$1/usr/lib/modules/$release/"
    for module in $2; do
        modprobe -d "$kernel_root" -S "$release" --show-depends "$module" 2>/dev/null ||
            echo "image: the kernel has no module $module" >&2
    done | awk '$1 == "insmod" { print $2 }' | sort -u | while read -r file; do
        to=$1/usr/lib/modules/$release/${file#"$kernel_root/lib/modules/$release/"}
        mkdir -p "${to%/*}"
        case $file in # Decompressed here, because the modprobe of busybox cannot read xz.
            *.xz) xz -dc "$file" >"${to%.xz}" ;;
            *) cp "$file" "$to" ;;
        esac
    done
    [ -e "$1/lib" ] || ln -s usr/lib "$1/lib"
    depmod -b "$1" "$release"
}

# Makes the folder that the initramfs mounts over the modules of each system. The modules for USB disks lie in a tree of
# their own, so that udev cannot load them: only the update page does (modprobe --dirname).
make_kernel_modules() { # FOLDER
    local release
    release=$(cat "$kernel_root/release")
    mkdir -p "$1"
    install_modules "$1" "$boot_modules $modules"
    mv "$1/usr/lib/modules/$release" "$1/$release"
    rm -r "$1/usr" "$1/lib"
    install_modules "$1/usb-disk" "$usb_disk_modules"
}

# Makes the initramfs, $IMAGE/initrd.zst, of a board with two root slots, or of a system that is only an initramfs.
# The sourcing script may define fill_initrd, which adds the files of the board.
make_initrd() { # FOLDER of busybox in the package
    local image=$IMAGE/initrd
    rm -rf "$image"
    mkdir -p "$image/bin"
    cp "$kernel_root/$1/busybox" "$image/bin/busybox"
    echo "$boot_modules" >"$image/boot_modules"
    install_modules "$image" "$boot_modules"
    if [ "${layout:-root}" = root ]; then
        install "$here/initramfs" "$image/init"
        install -m 644 "$here/slots/slots.sh" "$image/slots.sh"
        make_kernel_modules "$image/kernel-modules"
    fi
    ! declare -F fill_initrd >/dev/null || fill_initrd "$image"
    find "$image" -exec touch -h -d "@$made_s" {} +
    (cd "$image" && find . | LC_ALL=C sort | cpio -o -H newc --quiet --reproducible -R 0:0) | zstd -q -f -9 -o "$IMAGE/initrd.zst"
    rm -rf "$image"
}
