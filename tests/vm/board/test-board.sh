#!/bin/bash
# test-board.sh -- runs the tests of the card of `make image BOARD=rpi4` that MACHINES names:
#   parts    each part of each board has a driver on the card, each device tree has the names of the cabinet's lines, and
#            config.txt names only what is on the card (parts.py)
#   raspi3b  QEMU's Raspberry Pi 3 starts the card (raspi3b.sh)
#   virt     QEMU's machine `virt` starts the card: a screen whose driver comes late, a round, kill -9, a hang (image/test-image.sh)
#   power    COUNT power cuts (default 3) of that machine while coins are inserted and rounds run (image/kills.sh). Without a
#            screen a start takes 5 to 6 minutes on a busy computer; with SCREEN=yes, 9 to 13
#   selftest QEMU's machine `virt` starts the card with the word of its self-test (selftest.sh)
#   poi      QEMU's machine `virt` starts the card of a poi (poi.sh); needs `make image BOARD=poi`
# board/rpi4/README.md lists what each of them covers. Exit code 0: all passed.
set -u
export BUILD=${BUILD:-build}
here=$(dirname "$0")
cards=$BUILD/image/rpi4 cache=$BUILD/image/trixie-arm64
failed=0

parts() {
    local folder
    folder=$(mktemp -d)
    mcopy -s -i "$cards/kingyo.img@@4M" '::*' "$folder/" && zstd -dcq "$folder/initrd" | cpio -t --quiet >"$folder/list" &&
        "$here/parts.py" "$cache/kernel" "$folder" "$folder/list" "$here/left_out.txt" "$here/../../../board/rpi4/lines.conf"
    local code=$?
    rm -r "$folder"
    return $code
}

for machine in ${MACHINES:-parts raspi3b virt power selftest poi}; do
    case $machine in
        parts) parts ;;
        raspi3b) "$here/modules.sh" && "$here/raspi3b.sh" ;;
        virt) "$here/modules.sh" && CARD=rpi4 PARTS=${PARTS-late round ends} VM_SECONDS=${VM_SECONDS:-7200} "$here/../image/test-image.sh" ;;
        power)
            "$here/modules.sh" && CARD=rpi4 KILLS=${COUNT:-3} JOBS=1 COLD=1 OPEN_ROUNDS=1 SCREEN=${SCREEN:-no} VM_SECONDS=${VM_SECONDS:-3600} \
                "$here/../image/kills.sh"
            ;;
        selftest) "$here/modules.sh" && "$here/selftest.sh" ;;
        poi) "$here/modules.sh" && "$here/poi.sh" ;;
        *) echo "test-board: there is no machine '$machine'" >&2; exit 2 ;;
    esac || { echo "test-board: $machine failed" >&2; failed=1; }
done
exit $failed
