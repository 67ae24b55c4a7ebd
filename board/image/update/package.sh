# package.sh -- verifies an update package and writes it to the idle root slot. kingyo-update and the tests source this
# file after slots.sh, and set the variables below.
#
#   memory   a folder in memory, which no other user can write
#   key      the public key of minisign, chosen when the image was built
#   own      a file with the board, the version number and the slot of the running system
#   slots    the partition with the state of the slots
#   idle     the partition of the slot that is not running
#
# The sourcing script defines progress STATE PERCENT, which returns 1 to cancel, and has_stick. Each function returns 0,
# or returns 1 and sets fault to the reason: one of the words of the table in UPDATE.md.
# shellcheck shell=dash disable=SC2034,SC2154  # the sourcing script uses and sets the variables

package_chunk=4194304   # Bytes of a chunk, which is small enough for memory and large enough for a fast card.
package_chunk_max=1000  # Chunks of a package, 4 GB: the largest file of FAT32.
package_small_max=81920 # Bytes of the largest manifest and of a signature.

package_fail() { # FAULT
    fault=$1
    return 1
}

# Fails with `pulled` if the stick is gone, because that explains every other fault.
package_fail_read() { # FAULT
    has_stick || set -- pulled
    package_fail "$1"
}

package_copy() { # FILE TO: copies a small file to memory. The file may change or block while it is read.
    dd if="$1" of="$2" bs=$((package_small_max + 1)) count=1 iflag=fullblock,nofollow,nonblock status=none 2>/dev/null &&
        [ "$(stat -c %s "$2")" -le "$package_small_max" ]
}

package_is_number() { # WORD: a decimal number of at most twelve digits
    case $1 in '' | 0?* | *[!0-9]* | ?????????????*) return 1 ;; esac
}

# Sets board, version, name and size to the values of the signed manifest in memory. Creates the file sums with one line
# for each chunk.
package_parse() {
    local kind_line board_line version_line name_line size_line rest
    {
        IFS= read -r kind_line && IFS= read -r board_line && IFS= read -r version_line &&
            IFS= read -r name_line && IFS= read -r size_line && cat >"$memory/sums"
    } <"$memory/manifest" || return 1
    board=${board_line#board } version=${version_line#version } name=${name_line#name } size=${size_line#size }
    [ "$kind_line" = 'kingyo-update 1' ] && [ "$board_line" = "board $board" ] &&
        [ "$version_line" = "version $version" ] && [ "$name_line" = "name $name" ] && [ "$size_line" = "size $size" ] &&
        package_is_number "$version" && package_is_number "$size" && [ "$size" -gt 0 ] && [ $((size % 4096)) -eq 0 ] &&
        [ "${#name}" -le 60 ] || return 1
    chunk_count=$(((size + package_chunk - 1) / package_chunk))
    [ "$chunk_count" -le "$package_chunk_max" ] && [ "$(wc -l <"$memory/sums")" -eq "$chunk_count" ] &&
        ! grep -qvE '^[0-9a-f]{64}$' "$memory/sums"
}

package_own() { # NAME: prints a value of the running system.
    sed -n "s/^$1 //p" "$own"
}

package_slot_size() {
    if [ -b "$idle" ]; then blockdev --getsize64 "$idle"; else stat -c %s "$idle"; fi
}

# Reads the manifest of the package in FOLDER. All later steps use the copy in memory, whose signature is valid.
package_open() { # FOLDER
    folder=$1
    [ -d "$folder" ] && [ -e "$folder/manifest" ] && [ -e "$folder/root.sqfs" ] || { package_fail_read no-folder; return; }
    [ -e "$folder/manifest.minisig" ] || { package_fail_read unsigned; return; }
    package_copy "$folder/manifest" "$memory/manifest" &&
        package_copy "$folder/manifest.minisig" "$memory/manifest.minisig" || { package_fail_read damaged; return; }
    minisign -V -q -p "$key" -m "$memory/manifest" -x "$memory/manifest.minisig" >/dev/null 2>&1 ||
        { package_fail wrong-key; return; }
    package_parse || { package_fail damaged; return; }
    [ "$board" = "$(package_own board)" ] || { package_fail wrong-board; return; }
    [ "$version" -ne "$(package_own version)" ] || { package_fail same-version; return; }
    [ "$version" -gt "$(package_own version)" ] || { package_fail older; return; }
    [ "$size" -le "$(package_slot_size)" ] || { package_fail too-large; return; }
}

# Reads a chunk of the package into memory and compares it with the manifest. Sets length to its size in bytes.
package_load() { # INDEX
    length=$((size - $1 * package_chunk))
    [ "$length" -le "$package_chunk" ] || length=$package_chunk
    dd if="$folder/root.sqfs" of="$memory/chunk" bs="$package_chunk" skip="$1" count=1 iflag=fullblock,nofollow \
        status=none 2>/dev/null || { package_fail_read damaged; return; }
    [ "$(stat -c %s "$memory/chunk")" -eq "$length" ] && sum=$(sha256sum <"$memory/chunk") &&
        [ "${sum%% *}" = "$(sed -n "$(($1 + 1))p" "$memory/sums")" ] || { package_fail_read damaged; return; }
}

# Compares the whole package with the manifest. Writes nothing.
package_check() {
    local at=0
    while [ "$at" -lt "$chunk_count" ]; do
        progress checking $((at * 100 / chunk_count)) || { package_fail canceled; return; }
        package_load "$at" || return 1
        at=$((at + 1))
    done
}

package_put() { # FIRST LAST: writes the blocks of 4 KiB of the chunk in memory, and waits until they are on the disk.
    dd if="$memory/chunk" of="$idle" bs=4096 skip="$1" seek=$((index * package_chunk / 4096 + $1)) count=$(($2 - $1)) \
        conv=notrunc,fsync status=none 2>/dev/null
}

# Reads the chunk from the disk, without the cache of the kernel, and compares it with the chunk in memory.
package_compare() {
    dd if="$idle" bs="$package_chunk" skip="$index" count="$length" iflag=fullblock,direct,count_bytes status=none 2>/dev/null |
        cmp -s - "$memory/chunk"
}

# Writes the chunk in memory. A start needs the first block of a slot, the header of the file system, so that block is
# written when all other blocks are on the disk.
package_save() { # INDEX
    index=$1
    if [ "$index" -eq 0 ]; then
        package_put 1 $((length / 4096)) && package_put 0 1
    else
        package_put 0 $((length / 4096))
    fi && package_compare || package_fail card
}

# Writes the package to the idle slot, and gives the new system two starts. Checks each chunk again, because a stick may
# have other contents now. Until the last step the machine starts the running system.
package_write() {
    local running done_count=0 at=1
    running=$(package_own slot)
    # The running system must be good, because the write deletes the other one.
    ! slots_read "$slots" || [ "$trial" != "$running" ] || { package_fail on-trial; return; }
    slots_write "$slots" "$running" - 0 || { package_fail card; return; }
    dd if=/dev/zero of="$idle" bs=4096 count=1 conv=notrunc,fsync status=none 2>/dev/null || { package_fail card; return; }
    while [ "$done_count" -lt "$chunk_count" ]; do
        [ "$at" -lt "$chunk_count" ] || at=0
        progress writing $((done_count * 100 / chunk_count)) || { package_fail canceled; return; }
        package_load "$at" && package_save "$at" || return 1
        at=$((at + 1)) done_count=$((done_count + 1))
    done
    slots_write "$slots" "$running" "$(slots_other "$running")" 2 || package_fail card
}
