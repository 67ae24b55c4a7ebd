# lib.sh -- functions that the scripts of this folder share. Source the file after ../lib.sh.
# shellcheck shell=bash disable=SC2034,SC2154  # the scripts that source this file set and use the variables

# The number of a disk, by which the initramfs and fstab identify the card.
disk_id=4b696e67
layout=${layout:-root} # Or `initramfs`: the card has no other system, and no data partition.

# Prints the packages of ../packages.txt, separated by commas. image.conf changes names that differ between releases.
root_packages() {
    awk '!/^#/ && NF { print $1 }' "$here/packages.txt" | sed "$package_edits" | paste -s -d ,
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
