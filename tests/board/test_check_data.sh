#!/bin/bash
# test_check_data.sh -- what the data partition's check makes of its own mark; mount and disk are stood in for.
# Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
data=$work/data bin=$work/bin
mkdir "$data" "$bin"
stand_in() { # NAME LINES...
    printf '%s\n' '#!/bin/sh' "${@:2}" >"$bin/$1"
    chmod +x "$bin/$1"
}
stand_in mountpoint 'exit 0'
stand_in findmnt '[ "$3" = SOURCE ] && echo /dev/sda3 || echo ext4'
stand_in mount 'echo "$@" >>'"$work/mounts"
stand_in dd 'cat "${1#if=}"' # A file system in memory may have no direct reads.

after() { # MARK WANTED: the folder keeps, and the mark is WANTED afterwards.
    rm -f "$work/mounts"
    printf "$1" >"$data/.persists"
    PATH=$bin:$PATH sh board/kiosk/check-data "$data" "$work/told" || return 1
    cat "$work/told"
    [ ! -e "$work/mounts" ] && grep -q "^kept: /dev/sda3, ext4; start $2 of this disk" "$work/told" &&
        [ "$(cut -d' ' -f1 "$data/.persists")" = "$2" ]
}
is_read_only_when() { # COMMAND...: makes the mark unreadable.
    rm -rf "$work/mounts" "$data/.persists"
    "$@" || return 1
    PATH=$bin:$PATH sh board/kiosk/check-data "$data" "$work/told" && return 1
    grep -q '^not kept: .*cannot be read' "$work/told" && grep -q 'remount,bind,ro' "$work/mounts"
}

check 'the next start is counted' after '7 b3c1\n' 8
check 'the one before is named' grep -q 'the one before was b3c1' "$work/told"
check 'a mark without a byte begins anew' after '' 1
check 'a mark that was cut off counts' after '7' 8
check 'a mark that says anything begins anew' after '\001\377x\n' 1
check 'a mark that cannot be read shuts the folder' is_read_only_when mkdir "$data/.persists"
rm -rf "$data/.persists"
check 'no mark is the first start' bash -c "PATH=$bin:\$PATH sh board/kiosk/check-data $data $work/told && grep -q 'start 1 ' $work/told"
echo "1..$count"
