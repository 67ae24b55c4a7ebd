#!/bin/bash
# test_check_data.sh -- the check of the data partition and its read-only remount in hostile
# folders with links, FIFOs, devices and invalid marks. The disk is simulated. The mounts are real
# if this machine allows them. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
data=$work/data bin=$work/bin precious=$work/precious
mkdir "$bin"
stand_in() { # NAME LINES...
    printf '%s\n' '#!/bin/sh' "${@:2}" >"$bin/$1"
    chmod +x "$bin/$1"
}
stand_in mountpoint 'exit 0'
stand_in findmnt 'case $* in *SOURCE*) echo /dev/sda3 ;; *FSROOT*) echo "${FSROOT-/}" ;; *) echo ext4 ;; esac'
# A file system in memory may not support direct reads.
stand_in dd 'for word; do shift; set -- "$@" "$(echo "$word" | sed "s/,direct$//")"; done' "exec $(command -v dd) \"\$@\""

fresh() { # Creates an empty folder, and a file elsewhere that must stay unchanged.
    rm -rf "$data" && mkdir "$data" && echo precious >"$precious"
}
probe() { # Fails after 10 s, which is long enough for a loaded machine.
    PATH=$bin:$PATH timeout 10 sh board/kiosk/check-data "$data" >"$work/output" 2>"$work/err"
    local code=$?
    cat "$work/output" "$work/err"
    [ "$(cat "$precious")" = precious ] && [ ! -e "$work/owned" ] || { echo 'a file outside the folder changed'; return 99; }
    [ "$(wc -l <"$work/output")" -eq 1 ] || { echo 'not one line'; return 98; }
    return $code
}
keeps() { # COUNT: The check succeeds, and the mark is a regular file with the count COUNT.
    probe && grep -q "^kept: /dev/sda3, ext4; start $1 of this disk" "$work/output" && [ ! -L "$data/.persists" ] &&
        [ "$(cat "$data/.persists")" = "$1 $(cat /proc/sys/kernel/random/boot_id)" ] && [ ! -e "$data/.persists.new" ]
}
after() { # MARK COUNT
    fresh && printf -- "$1" >"$data/.persists" && keeps "$2"
}
keeps_with() { # COMMAND...: The command prepares a hostile folder, which must not affect the result.
    fresh && "$@" && keeps 1
}
fails_with() { # PATTERN COMMAND...
    fresh && "${@:2}" || return 1
    probe
    [ $? -eq 1 ] && grep -q "^not kept: .*$1" "$work/output" && [ "$(cat "$precious")" = precious ]
}

# ---- The mark
check 'a folder without a mark counts as the first start' keeps_with true
check 'the next start is counted' after '7 b3c1\n' 8
check 'the previous start is named' grep -q 'the one before was b3c1' "$work/output"
check 'an empty mark restarts the count' after '' 1
check 'a truncated mark is counted' after '7' 8
for mark in '08 b3c1' '09' '0' '-1 x' '+7' '0x10' '12345678901234567890 b3c1' '9999999999' '1;id' '1+1' 'a[$(touch owned)] 1' \
    '\001\377x' '7\033[2J' ' 7'; do
    check "the mark '$mark' restarts the count" after "$mark\n" 1
done
check 'an invalid id of the previous start is not printed' after '7 \033[2J;touch\n' 8
check 'an invalid id of the previous start is not in the journal' grep -q 'the one before was never' "$work/err"
long() { fresh && { printf '7 '; head -c 1000000 /dev/zero | tr '\0' a; } >"$data/.persists" && keeps 8; }
check 'only the beginning of a mark of 1 MiB is read' long

# ---- Hostile entries of the folder
check 'a link in place of the new mark is not followed' keeps_with ln -s "$precious" "$data/.persists.new"
check 'a link to a missing file in place of the new mark is not followed' keeps_with ln -s "$work/owned" "$data/.persists.new"
check 'a FIFO in place of the new mark does not block' keeps_with mkfifo "$data/.persists.new"
check 'a folder in place of the new mark is a failure' fails_with 'cannot be written' mkdir "$data/.persists.new"
check 'a link in place of the mark is a failure' fails_with 'cannot be read' ln -s "$precious" "$data/.persists"
check 'a link to a missing file in place of the mark is a failure' fails_with 'cannot be read' ln -s "$work/owned" "$data/.persists"
check 'a FIFO in place of the mark fails immediately' fails_with 'cannot be read' mkfifo "$data/.persists"
check 'a folder in place of the mark is a failure' fails_with 'cannot be read' mkdir "$data/.persists"
check 'a folder that is not a mount point is a failure' env FSROOT=/kingyo bash -c "$(declare -f fresh probe fails_with)
    work=$work data=$data bin=$bin precious=$precious; fails_with 'no partition of its own' true"
stand_in dd 'exit 1'
check 'a disk whose reads and writes fail is a failure' fails_with 'cannot be' true

# ---- The remount
protects() { # RESULT: Runs as root in mounts of its own. Every file of the folder is hostile.
    fresh && ln -s "$precious" "$data/.persists" && mkfifo "$data/.persists.new" "$data/kingyo.db" || return 1
    rm -f "$work/output"
    SERVICE_RESULT=$1 unshare -m sh -c "timeout 10 sh board/kiosk/protect-data '$data' '$work/output' || exit 2
        touch '$data/new' || exit 1"
}
shuts() { # RESULT
    protects "$1"
    [ $? -eq 1 ] && [ "$(cat "$precious")" = precious ] && grep -q "^not kept: .*$1" "$work/output"
}
opens() { protects success && [ -e "$data/new" ] && [ ! -e "$work/output" ]; }
keeps_words() {
    fresh && echo 'not kept: /dev/sda3 is gone' >"$work/output" || return 1
    SERVICE_RESULT=exit-code unshare -m sh board/kiosk/protect-data "$data" "$work/output"
    [ "$(cat "$work/output")" = 'not kept: /dev/sda3 is gone' ]
}
if [ "$(id -u)" -eq 0 ] && unshare -m true 2>/dev/null; then
    for result in exit-code timeout signal core-dump resources ''; do
        check "a check that ended with '$result' makes the folder read-only" shuts "$result"
    done
    check 'a successful check leaves the folder writable' opens
    check 'the reason that the check reported is kept' keeps_words
    cannot() { # If the remount fails, an empty folder covers the data folder.
        stand_in mount 'case $* in *remount*) exit 32 ;; esac' "exec $(command -v mount) \"\$@\""
        rm -f "$bin/findmnt" "$bin/mountpoint"
        fresh && echo x >"$data/file"
        PATH=$bin:$PATH SERVICE_RESULT=timeout unshare -m sh -c "sh board/kiosk/protect-data '$data' '$work/output' &&
            [ ! -e '$data/file' ] && ! touch '$data/new'"
    }
    check 'a failed remount still prevents writing' cannot
else
    skip 'a failed check makes the folder read-only' 'no root, or no mounts'
fi

# ---- The unit: only the remount runs as root
unit=board/systemd/kingyo-data.service
as_user() { grep -qx 'User=kingyo' $unit && grep -q '^ExecStart=@PREFIX@/lib/kingyo/check-data ' $unit && ! grep -q '^ExecStart=[+!]' $unit; }
check 'the check runs as the service user' as_user
check 'the remount runs as root after every end of the check' grep -q '^ExecStopPost=+@PREFIX@/lib/kingyo/protect-data ' $unit
check 'the script that runs as root opens no file in the folder' bash -c '! grep -nE "\\\$folder[\"'\'']?/|\\\$1/" board/kiosk/protect-data'
# systemd opens the file of `file:` without emptying it, so the end of a longer old line would stay behind a shorter new
# line. `truncate:` would empty the file for ExecStopPost too, and protect-data could not read the reason.
check 'the result of an older check is removed before the check' grep -qx 'ExecStartPre=+/bin/rm -f /run/kingyo-data' $unit
check 'the result of the check is still there when protect-data reads it' grep -qx 'StandardOutput=file:/run/kingyo-data' $unit
if command -v systemd-analyze >"$work/which"; then
    sound() { # systemd accepts every line of the unit. The two scripts are replaced by a program that exists.
        sed 's|@PREFIX@/lib/kingyo/[a-z-]*|/bin/true|; s/^User=.*/User=root/; s/^Group=.*/Group=root/' $unit >"$work/kingyo-data.service" &&
            systemd-analyze verify --man=no "$work/kingyo-data.service" >"$work/verified" 2>&1
        cat "$work/verified"
        ! grep -q 'kingyo-data.service' "$work/verified"
    }
    check 'systemd-analyze finds no mistake in the unit of the check' sound
else
    skip 'systemd-analyze finds no mistake in the unit of the check' 'there is no systemd-analyze'
fi
echo "1..$count"
