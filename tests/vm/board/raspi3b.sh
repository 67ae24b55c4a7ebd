#!/bin/bash
# raspi3b.sh -- boots the card of `make image BOARD=rpi4` in QEMU's `raspi3b` and checks the parts of the board that this
# machine emulates: SD card, GPIO, watchdog, clocks, USB host. guest/pi.sh is the part in the guest.
# The picture comes through a frame buffer, because QEMU emulates no GPU of a Raspberry Pi. Exit code 0: all checks passed.
# shellcheck disable=SC2154,SC1091,SC2034,SC2054  # the sourced files set and use these variables; QEMU needs the commas
GUEST=card
BUILD=${BUILD:-build}
. "$(dirname "$0")/../lib.sh"
modules_cache=$cache
cache=$BUILD/vm/raspi3b
mkdir -p "$cache"
cache=$(cd "$cache" && pwd)
image=$(cd "$BUILD/image/${CARD:-rpi4}" && pwd)
. "$here/qemu.sh"
. "$here/results.sh"
. "$here/board/card.sh"
limit_s=${VM_SECONDS:-5400}
initrd=$cache/initrd.zst disk=$run/card.img
busybox=$BUILD/image/$suite-$arch/kernel/usr/bin/busybox
width=320 height=180 frame_buffer=3c100000 # QEMU's video memory: the start of the GPU's memory and 1 MiB.
trap guest_stop EXIT
trap 'exit 143' TERM INT HUP

# Adds a frame buffer to the board's device tree, as the firmware of a board does.
add_frame_buffer() { # IN OUT
    local node=/framebuffer@$frame_buffer
    cp "$1" "$2"
    fdtput -c "$2" "$node"
    fdtput "$2" "$node" compatible -ts kingyo,simpledrm
    fdtput "$2" "$node" reg -tx "$frame_buffer" "$(printf %x $((width * height * 4)))"
    fdtput "$2" "$node" width -tu $width
    fdtput "$2" "$node" height -tu $height
    fdtput "$2" "$node" stride -tu $((width * 4))
    fdtput "$2" "$node" format -ts x8r8g8b8
}

make_test_initrd() {
    local folder=$cache/initrd release modules='simpledrm'
    release=$(cat "$modules_cache/kernel/release")
    rm -rf "$folder"
    mkdir -p "$folder"/{bin,usr/lib/modules/"$release",host/units/multi-user.target.wants}
    ln -s usr/lib "$folder/lib"
    cp "$busybox" "$folder/bin/busybox"
    install "$here/board/guest/rdinit" "$folder/rdinit"
    echo "$modules" >"$folder/test_modules"
    cp -r "$here/board/units/." "$here/board/pi-units/." "$folder/host/units/"
    cp "$here/board/guest/pi.sh" "$folder/host/"
    cp "$modules_cache/kernel/lib/modules/$release"/modules.{builtin,builtin.modinfo,order} "$folder/lib/modules/$release/"
    copy_modules "$modules_cache/kernel" "$release" "$folder" "$modules $(card_modules)"
    {
        zstd -dc "$boot/initrd"
        (cd "$folder" && find . | cpio -o -H newc --quiet)
    } | zstd -q -f -3 -o "$initrd"
    rm -rf "$folder"
}

# The drivers of the GPU's sound do not come back from QEMU's mailbox, so the kernel does not load them here.
qemu_words() {
    printf '%s\n' -M raspi3b -kernel "$boot/linux" -initrd "$initrd" -dtb "$cache/board.dtb" \
        -append "$(cat "$boot/cmdline.txt") console=ttyS1,115200 rdinit=/rdinit mitigations=off module_blacklist=vchiq,snd_bcm2835 ${WORDS-}" \
        -drive "if=sd,format=raw,file=$disk" -global "bcm2835-fb.xres=$width" -global "bcm2835-fb.yres=$height" \
        -global bcm2835-fb.bpp=32 -global bcm2835-fb.pixo=0 -display none -no-reboot -action watchdog=reset \
        -serial null -serial "file:$share/out/talk" -qmp "pipe:$run/qmp" -accel tcg,thread=multi,tb-size=512
}

heard() { # Handles one line of the console.
    set -- $1
    [ "${1-}" = kt ] || return 0
    case ${2-} in
        ok | bad) record_result "${@:2}" ;;
        end) qmp quit || true ;;
    esac
    printf '       %4d s: %s\n' "$SECONDS" "${*:2}"
}

rm -rf "$run" "$shots"
mkdir -p "$share"/{out,shots} "$shots"
unpack_boot
add_frame_buffer "$boot/bcm2837-rpi-3-b.dtb" "$cache/board.dtb"
make_test_initrd
cp --sparse=always "$image/kingyo.img" "$disk"
truncate -s 2G "$disk" # QEMU requires a power of two.
step 'boots the card in raspi3b'
guest_start "$limit_s"
guest_listen
step "the machine is off (qemu ended with $qemu_status)"
check_tank tank picture
table "$here/board/checks.txt" "the card in QEMU's raspi3b" | tee "$cache/table.txt"
exit "${PIPESTATUS[0]}"
