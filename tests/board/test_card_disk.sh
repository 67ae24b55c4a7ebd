#!/bin/bash
# test_card_disk.sh -- the partitions of a memory card on a plain file with the partition table of the card: the initramfs
# finds each partition by its number, and enlarges only the data partition. Speaks TAP.
# shellcheck disable=SC2154,SC1091,SC2034  # the sourced files set and use these variables
. "$(dirname "$0")/../lib.sh"
cd "$(dirname "$0")/../.." || exit 1
top=$PWD here=$PWD/board/image
. board/rpi4/image.conf
. board/image/card/lib.sh
. board/image/system.sh
sys=$work/sys dev=$work/dev id_file=$work/disk_id
. board/image/card/disk.sh
echo "$disk_id" >"$id_file"
image_mib=$((data_at + data_size + 1))

field() { # NUMBER start|size: prints a number of the partition table, in sectors
    sfdisk -d "$dev/mmcblk0" | sed -n "s/^[^ ]*mmcblk0p*$1 : .*$2= *\([0-9]*\).*/\1/p"
}

# Makes a card of MIB with the image on it, and what the kernel shows of it in /sys. Another disk has another number.
card() { # MIB
    local number name
    rm -rf "$sys" "$dev"
    mkdir -p "$dev/kingyo" "$sys/block/mmcblk0" "$sys/block/another/anotherp6"
    truncate -s "${image_mib}M" "$dev/mmcblk0" "$dev/another"
    partitions | sfdisk -q "$dev/mmcblk0"
    partitions | sed 's/0x.*/0x11111111/' | sfdisk -q "$dev/another"
    truncate -s "$1M" "$dev/mmcblk0"
    echo $(($1 * 2048)) >"$sys/block/mmcblk0/size"
    echo 6 >"$sys/block/another/anotherp6/partition"
    : >"$dev/anotherp6"
    for number in 1 2 4 5 6 7; do
        name=mmcblk0p$number
        mkdir "$sys/block/mmcblk0/$name"
        echo $number >"$sys/block/mmcblk0/$name/partition"
        field $number start >"$sys/block/mmcblk0/$name/start"
        field $number size >"$sys/block/mmcblk0/$name/size"
        : >"$dev/$name"
    done
    reread=0 waited=0
}
blockdev() { reread=$((reread + 1)); }
await_partitions() { [ "$reread" -eq 1 ] && waited=1; }
is_block_device() { [ -e "$1" ]; } # The partitions of this test are plain files.

found() { # NAME PARTITION
    find_partition "$1" && readlink "$dev/kingyo/$1" && [ "$(readlink "$dev/kingyo/$1")" = "../mmcblk0p$2" ]
}
finds() { card "$image_mib" && found slots 5 && found root-a 6 && found root-b 7; }
check 'the state of the slots and the two root slots are partitions 5, 6 and 7 of the card' finds
late() { card "$image_mib" && rm -r "$sys/block/mmcblk0" && ! find_partition root-a && [ ! -e "$dev/kingyo/root-a" ]; }
check 'a card that is not detected yet has no partition, although another disk has one' late
late_partition() { card "$image_mib" && rm "$dev/mmcblk0p7" && ! find_partition root-b && found root-a 6; }
check 'a partition without a device is not detected yet' late_partition

slots_fit() { # The state has two copies, 512 KiB apart.
    card "$image_mib" && [ "$(field 5 size)" -eq 2048 ] && [ "$(field 6 size)" -eq "$(field 7 size)" ]
}
check 'the state has 1 MiB, and both root slots have the same size' slots_fit
valid() { sfdisk -V "$dev/mmcblk0" 2>&1 | tee /dev/stderr | grep -q 'No errors detected'; }
check 'the partition table is valid' valid
apart() { # From one partition to the next, the end of the first one is not above the start of the second one.
    local number end=0
    for number in 1 5 6 7 4; do
        [ "$(field $number start)" -gt "$end" ] || return 1
        end=$(($(field $number start) + $(field $number size) - 1))
    done
}
check 'no partition overlaps another one' apart

grown() { # MIB: the data partition of a card of this size has all the rest; all else is as before, and the partitions are awaited
    local before
    card "$1" && before=$(sfdisk -d "$dev/mmcblk0" | grep -v 'mmcblk0p*4') && find_disk && prepare_disk &&
        [ "$(field 4 size)" -eq $((($1 - data_at) * 2048 / 8192 * 8192)) ] && [ "$reread$waited" = 11 ] && valid &&
        [ "$(sfdisk -d "$dev/mmcblk0" | grep -v 'mmcblk0p*4')" = "$before" ]
}
for size in 2048 7580 121942; do
    check "the data partition fills a card of $size MiB, and no other entry changes" grown $size
done
kept() { # MIB
    card "$1" && cp "$dev/mmcblk0" "$work/before" && find_disk && prepare_disk && cmp "$dev/mmcblk0" "$work/before" && [ "$reread" -eq 0 ]
}
check 'a card of the size of the image is not written' kept "$image_mib"
twice() {
    card 2048 && find_disk && prepare_disk && field 4 size >"$sys/block/mmcblk0/mmcblk0p4/size" && prepare_disk && [ "$reread" -eq 1 ]
}
check 'the second start writes nothing' twice
huge() { # The table cannot have the size of such a partition. The kiosk runs with the partition of the image.
    card "$image_mib" && echo 8589934592 >"$sys/block/mmcblk0/size" && find_disk && prepare_disk && [ "$reread" -eq 0 ]
}
check 'a disk of 4 TiB keeps the partition of the image' huge
room() { # The limit, and the line that names the setting and the size that it needs.
    board=rpi4
    check_slot root_size 150 100 && ! check_slot root_size 149 100 2>"$work/why" &&
        grep -q 'has 100 MiB and needs slots of 150 MiB, but root_size in board/rpi4/image.conf is 149' "$work/why"
}
check 'a root slot has room for a system that is half as large again' room
echo "1..$count"
