# disk.sh -- a machine with the disk of `make image BOARD=vm`, or with the card of BOARD=$CARD. Source
# this file with BUILD and a name. BUILD/vm/NAME has the logs (run/) and the pictures (shots/).
# The disk contains no test files. Test files come in a second initramfs, whose program runs before
# the disk's own init (guest/rdinit), and through a shared folder.
# shellcheck shell=bash disable=SC2154,SC1091,SC2034,SC2054  # the sourcing scripts use these variables; QEMU needs the commas
CARD=${CARD:-} GUEST=${CARD:+card}
GUEST=${GUEST:-bookworm}
. "$(dirname "${BASH_SOURCE[0]}")/../lib.sh"
modules_cache=$cache
shaders=$modules_cache/image-mesa # Shaders that an earlier machine compiled.
cache=$BUILD/vm/${1:?a name}
mkdir -p "$cache"
cache=$(cd "$cache" && pwd)
image=$(cd "$BUILD/image/${CARD:-vm}" && pwd)
. "$here/qemu.sh"
. "$here/results.sh"
processors=2 test_words=''
programs=$BUILD busybox=$modules_cache/busybox kernel_image=$modules_cache/kernel/image image_initrd=$image/initrd.zst
image_words=$image/kernel_words
width=160 height=120 # A picture of this size is drawn several times a second.
disk=$run/disk.img initrd=$cache/initrd.zst
late_modules='' # Drivers that the guest loads later, from /run/late.
test_modules='virtio_pci virtio_blk squashfs 9p 9pnet_virtio configfs gpio-sim dummy_hcd libcomposite usb_f_hid usb_f_mass_storage
    usb_f_ecm usb_f_acm'

# Two virtual cables: one for our poi, and one for a foreign device.
make_test_initrd() {
    local folder=$cache/initrd release
    release=$(cat "$modules_cache/kernel/release")
    rm -rf "$folder"
    mkdir -p "$folder"/{bin,usr/lib/modules/"$release"}
    ln -s usr/lib "$folder/lib"
    cp "$busybox" "$folder/bin/busybox"
    install "$here/image/guest/rdinit" "$folder/rdinit"
    echo "$test_modules" >"$folder/test_modules"
    echo 'dummy_hcd num=2 is_high_speed=1' >"$folder/test_options"
    [ -z "$late_modules" ] || : >"$folder/late_modules"
    cp "$modules_cache/kernel/lib/modules/$release"/modules.{builtin,builtin.modinfo,order} "$folder/lib/modules/$release/"
    copy_modules "$modules_cache/kernel" "$release" "$folder" "$test_modules $late_modules $(card_modules)"
    {
        zstd -dc "$image_initrd"
        (cd "$folder" && find . | cpio -o -H newc --quiet)
    } | zstd -q -f -3 -o "$initrd"
    rm -rf "$folder"
}

make_share() { # SCRIPT of guest/ that the guest runs
    rm -rf "$run" "$shots"
    mkdir -p "$share"/{bin,guest,out,shots,units} "$shots"
    cp -r "$here/image/guest/units/." "$share/units/"
    if [ -n "$CARD" ]; then
        cp -r "$here/board/units/." "$share/units/"
        cp -r "$here/board/system.conf.d" "$share/"
    fi
    # An emulated machine on a busy host may detect its disk after more than the 30 s of /etc/fstab.
    local units='dev-disk-by\x2dpartlabel-kingyo\x2ddata.device.d'
    mkdir -p "$share/units/$units"
    printf '[Unit]\nJobRunningTimeoutSec=10min\n' >"$share/units/$units/60-patience.conf"
    cp "$here"/guest/{lib,cabinet,poi}.sh "$here"/image/guest/*.sh "$share/guest/"
    printf '[game]\nround = 10\n' >"$share/kingyo.conf"
    echo "$1" >"$share/script"
    chmod 777 "$share/out"
    cp "$programs/kingyo-poi" "$programs"/tests/vm/{panel,as,image/hold} "$top/board/poi-gadget/kingyo-poi-gadget" "$share/bin/"
    cp "$busybox" "$share/bin/busybox"
    for tool in pidof killall; do ln -s busybox "$share/bin/$tool"; done
    # The guest of test-vm has the same processor and the same Mesa, so its shaders are valid here.
    local kept
    for kept in "$modules_cache"/mesa/mesa_shader_cache* "$shaders"/mesa_shader_cache*; do
        [ ! -d "$kept" ] || { mkdir -p "$share/mesa" && cp -r "$kept" "$share/mesa/"; }
    done
}

keep_shaders() { # Keeps the compiled shaders for the next machine (guest/common.sh).
    [ ! -d "$share/out/mesa" ] || { rm -rf "$shaders"; mv "$share/out/mesa" "$shaders"; }
}

# Copies the unchanged disk of the image. A card is larger than its image.
fresh_disk() { # [FILE]
    cp --sparse=always "$image/kingyo.img" "${1:-$disk}"
    [ -z "$CARD" ] || truncate -s 2G "${1:-$disk}"
}

disk_words() { # plug.sh overrides this function.
    echo "-drive"
    echo "file=$disk,format=raw,if=virtio"
}

card_modules() { :; } # board/card.sh overrides this function.

machine_words() { # board/virt.sh overrides this function.
    printf '%s\n' -machine q35 -cpu qemu64,+ssse3,+sse4.1,+sse4.2,+popcnt
}

qemu_words() { # The machine has 2 processors and 1 GiB, as in tests/vm/qemu.sh.
    machine_words
    printf '%s\n' -nodefaults -no-user-config -display none -smp "$processors" -m 1024 \
        -kernel "$kernel_image" -initrd "$initrd" \
        -append "$(cat "$image_words") $test_words rdinit=/rdinit loglevel=4 mitigations=off" \
        -fsdev "local,id=host,path=$share,security_model=none" -device virtio-9p-pci,fsdev=host,mount_tag=host \
        -device "virtio-gpu-pci,xres=$width,yres=$height,edid=off" -device i6300esb -action watchdog=reset -no-reboot \
        -serial "file:$run/console" -qmp "pipe:$run/qmp" -accel tcg,thread=multi,tb-size=512
    disk_words
}
[ -z "$CARD" ] || . "$here/board/virt.sh"

# Defines qemu_words again, for a machine without a screen, in which nothing is drawn.
remove_screen() {
    eval "with_screen_$(declare -f qemu_words)"
    qemu_words() {
        with_screen_qemu_words | awk '$0 == "-device" { held = 1; next }
            held { held = 0; if (/virtio-gpu/) next; print "-device" }
            { print }'
    }
}

# The kiosk of a card waits for a screen. Without a screen, this wait ends after a second. Call after make_share.
expect_no_screen() {
    if [ -n "$CARD" ]; then
        printf '[Unit]\nJobRunningTimeoutSec=1s\n' >"$share/units/dev-kingyo-screen.device.d/95-no-screen.conf"
    fi
}
