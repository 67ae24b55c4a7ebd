# lib.sh -- functions that the scripts of this folder share. Source the file after ../lib.sh.
# shellcheck shell=bash disable=SC2034,SC2154  # the scripts that source this file set and use the variables

# The number of a disk, by which the initramfs and fstab identify the card.
disk_id=4b696e67
layout=${layout:-root} # Or `initramfs`: the card has no other system, and no data partition.

# Prints the packages of ../packages.txt, separated by commas. image.conf changes names that differ between releases.
root_packages() {
    awk '!/^#/ && NF { print $1 }' "$here/packages.txt" | sed "$package_edits" | paste -s -d ,
}

# The starts of the partitions, in MiB. image.conf has their sizes.
boot_at=4
slots_at=$((boot_at + boot_size + 1))
root_at=$((slots_at + 2))
data_at=$((root_at + 2 * ${root_size:-0} + 1))

# Prints the partition table for sfdisk. The table has room for four partitions. The second one therefore contains others:
# the state of the slots (5) and the two root slots (6, 7). Each of them has 1 MiB of room for its own entry before it.
partitions() {
    echo "label: dos
label-id: 0x$disk_id
card1 : start=${boot_at}M, size=${boot_size}M, type=c, bootable"
    [ "$layout" = initramfs ] || echo "card2 : start=$((slots_at - 1))M, size=$((data_at - slots_at + 1))M, type=5
card4 : start=${data_at}M, size=${data_size}M, type=83
card5 : start=${slots_at}M, size=1M, type=83
card6 : start=${root_at}M, size=${root_size}M, type=83
card7 : start=$((root_at + root_size + 1))M, size=${root_size}M, type=83"
}

needs_tools() {
    local tool
    needs
    for tool in xz dpkg-scanpackages dtc fdtoverlay fdtput; do
        command -v "$tool" >/dev/null || {
            echo "image: $tool is not installed; board/setup.sh vm cross installs what is needed" >&2
            exit 1
        }
    done
    "$top/board/deb/emulate.sh" "$arch"
}
