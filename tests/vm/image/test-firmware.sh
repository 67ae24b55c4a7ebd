#!/bin/bash
# test-firmware.sh -- boots a machine that has only UEFI firmware and the disk, and waits for a
# picture of the tank.
# The disk contains no part of the test, which checks only the picture. The test then erases the
# data partition, and the kiosk must open again. Prints the time from power on to each picture.
# Exit code 0 means that both starts showed the tank.
# shellcheck disable=SC2154,SC1091,SC2034  # the sourced files set and use these variables
export BUILD=${BUILD:-build}
. "$(dirname "$0")/disk.sh" image-firmware
limit_s=${VM_SECONDS:-600}
firmware=/usr/share/OVMF/OVMF_CODE.fd
trap guest_stop EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

# The machine of a board: firmware, a disk, a screen and a sound card. The processor draws 300
# fish.
qemu_words() {
    printf '%s\n' -nodefaults -no-user-config -display none -smp 2 -m 1024 -machine q35 \
        -cpu qemu64,+ssse3,+sse4.1,+sse4.2,+popcnt -drive "if=pflash,format=raw,readonly=on,file=$firmware" \
        -drive "file=$disk,format=raw,if=virtio" -device "virtio-gpu-pci,xres=$width,yres=$height,edid=off" \
        -device i6300esb -no-reboot -serial "file:$run/console" -qmp "pipe:$run/qmp" -accel tcg,thread=multi,tb-size=512
}

# Prints the seconds from power on to the first picture of the tank, or nothing if it does not
# appear.
opens() { # NAME
    local began=$SECONDS it
    guest_start "$limit_s"
    while kill -0 "$qemu_pid" 2>/dev/null; do
        sleep 1
        qmp screendump "\"filename\":\"$shots/$1.png\",\"format\":\"png\"" || continue
        read -ra it < <(picture "$1") || true
        if shows_tank "${it[@]}"; then
            echo $((SECONDS - began))
            break
        fi
    done
    guest_stop
    wait "$qemu_pid" 2>/dev/null || true
}

wipe_data() { # Simulates a card that lost its data.
    local start
    start=$(sfdisk -d "$disk" | sed -n 's/.*start= *\([0-9]*\),.*name="kingyo-data".*/\1/p')
    dd if=/dev/zero of="$disk" bs=512 seek="$start" count=65536 conv=notrunc status=none
}

if [ ! -r "$firmware" ]; then
    echo "test-firmware: skipped: $firmware is missing; board/setup.sh vm installs it"
    exit 0
fi
mkdir -p "$run/share/out" "$run/share/shots" "$shots"
width=320 height=240
cp --sparse=always "$image/kingyo.img" "$disk"
first=$(opens firmware)
wipe_data
wiped=$(opens wiped)
printf 'firmware: the tank %s s after power on; %s s without its data partition\n' "${first:-never}" "${wiped:-never}"
[ -n "$first" ] && [ -n "$wiped" ]
