# disk.sh -- finds the partitions of a memory card, and enlarges the last one. The initramfs sources this file on a card.
#
# A card is identified by the number in its partition table (/disk_id), because that kind of table has no names.
# shellcheck shell=dash
sys=${sys:-/sys} dev=${dev:-/dev} id_file=${id_file:-/disk_id} # A test sets others.

# Sets disk to the folder of the card in /sys. Returns 1 if the card is not detected yet.
find_disk() {
    for disk in "$sys"/block/*; do
        id=$(dd if="$dev/${disk##*/}" bs=1 skip=440 count=4 2>/dev/null | od -An -tx4 | tr -d ' ')
        [ "$id" != "$(cat "$id_file")" ] || return 0
    done
    return 1
}

partition() { # NUMBER: prints the name of a partition of the card.
    for file in "$disk"/*/partition; do
        [ "$(cat "$file" 2>/dev/null)" = "$1" ] || continue
        file=${file%/partition}
        echo "${file##*/}"
        return
    done
    return 1
}

is_block_device() { [ -b "$1" ]; }

find_partition() { # NAME
    find_disk || return 1
    case $1 in slots) file=$(partition 5) ;; root-a) file=$(partition 6) ;; root-b) file=$(partition 7) ;; esac
    is_block_device "$dev/${file:-none}" && ln -sf "../$file" "$dev/kingyo/$1"
}

# Enlarges the data partition to the end of a card that is larger than the image: writes the number of sectors to the
# partition table. kingyo-grow.service then enlarges the file system. Numbers have 32 bits, as in the table. The kernel
# removes all partitions and detects them again. Returns 1 if no root slot appears again.
prepare_disk() {
    data=$(partition 4) || return 0
    start=$(cat "$disk/$data/start") have=$(cat "$disk/$data/size")
    want=$((($(cat "$disk/size") - start) / 8192 * 8192))
    [ "$want" -gt "$have" ] && [ "$want" -le 4294959104 ] || return 0
    printf "$(printf '\\%03o\\%03o\\%03o\\%03o' $((want & 255)) $((want >> 8 & 255)) $((want >> 16 & 255)) $((want >> 24 & 255)))" |
        dd of="$dev/${disk##*/}" bs=1 seek=506 conv=notrunc,fsync 2>/dev/null
    blockdev --rereadpt "$dev/${disk##*/}"
    await_partitions
}
