#!/bin/bash
# poi.sh -- boots the card of `make image BOARD=poi` in QEMU's machine `virt` and checks that the poi answers on its cable.
# dummy_hcd is both ends of the cable in place of the board's controller (dwc2), so the guest itself is the host. A second
# initramfs brings dummy_hcd and a program that reads the reports. Exit code 0: all checks passed.
# shellcheck disable=SC2154,SC1091,SC2034,SC2054  # the sourced files set and use these variables; QEMU needs the commas
GUEST=card
BUILD=${BUILD:-build}
. "$(dirname "$0")/../lib.sh"
modules_cache=$cache
cache=$BUILD/vm/poi
mkdir -p "$cache"
cache=$(cd "$cache" && pwd)
image=$(cd "$BUILD/image/poi" && pwd)
. "$here/qemu.sh"
. "$here/results.sh"
. "$here/board/card.sh"
limit_s=${VM_SECONDS:-1800}
initrd=$cache/initrd.zst disk=$run/card.img
busybox=$BUILD/image/$suite-$arch/kernel/usr/bin/busybox
trap guest_stop EXIT
trap 'exit 143' TERM INT HUP

make_test_initrd() {
    local folder=$cache/initrd release modules='virtio_pci virtio_blk dummy_hcd usbhid hid-generic i6300esb'
    release=$(cat "$modules_cache/kernel/release")
    rm -rf "$folder"
    mkdir -p "$folder"/{bin,test,usr/lib/modules/"$release"}
    ln -s usr/lib "$folder/lib"
    cp "$busybox" "$folder/bin/busybox"
    install "$here/board/guest/poi-rdinit" "$folder/rdinit"
    install "$here/board/guest/poi-host" "$folder/test/host"
    echo "$modules" >"$folder/test_modules"
    cp "$modules_cache/kernel/lib/modules/$release"/modules.{builtin,builtin.modinfo,order} "$folder/lib/modules/$release/"
    copy_modules "$modules_cache/kernel" "$release" "$folder" "$modules $(card_modules)"
    {
        zstd -dc "$boot/initrd"
        (cd "$folder" && find . | cpio -o -H newc --quiet)
    } | zstd -q -f -3 -o "$initrd"
    rm -rf "$folder"
}

qemu_words() {
    printf '%s\n' -M virt -cpu cortex-a53 -m 512 -smp 2 -nodefaults -no-user-config -display none -no-reboot \
        -kernel "$boot/linux" -initrd "$initrd" \
        -append "$(cat "$boot/cmdline.txt") console=ttyAMA0 kingyo.poi=simulate rdinit=/rdinit mitigations=off" \
        -drive "if=virtio,format=raw,file=$disk" -device i6300esb -action watchdog=reset \
        -serial "file:$share/out/talk" -qmp "pipe:$run/qmp" -accel tcg,thread=multi,tb-size=512
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
make_test_initrd
cp --sparse=always "$image/kingyo.img" "$disk"
# The ids that a person writes on the card.
printf 'VENDOR=0x1209\nPRODUCT=0x0001\nUDC=dummy_udc.0\n' >"$cache/gadget.conf"
mcopy -o -i "$disk@@$boot_at" "$cache/gadget.conf" ::gadget.conf
before=$(sha256sum <"$disk")
step 'boots the card of the poi'
guest_start "$limit_s"
guest_listen
step "the machine is off (qemu ended with $qemu_status)"
passes unwritten 'the card has the same bytes as before the start' -- [ "$(sha256sum <"$disk")" = "$before" ]
table "$here/board/poi_checks.txt" "the card of make image BOARD=poi" | tee "$cache/table.txt"
exit "${PIPESTATUS[0]}"
