#!/bin/bash
# test_update_package.sh -- update packages on plain files: each fault is found before anything is written, a package that
# changes while it is read gains nothing, and a cut at any step leaves the old system. Speaks TAP.
# shellcheck disable=SC2154,SC1091,SC2034  # lib.sh, slots.sh and package.sh set and use these variables
. "$(dirname "$0")/../lib.sh"
cd "$(dirname "$0")/../.." || exit 1
if ! command -v minisign >/dev/null; then
    skip 'update packages' 'minisign is not installed; board/setup.sh test installs it'
    echo "1..$count"
    exit 0
fi
. board/image/slots/slots.sh
. board/image/update/package.sh
memory=$work/memory key=$work/key.pub own=$work/own slots=$work/slots idle=$work/idle package=$work/stick/kingyo-update
mkdir "$memory" "$work/stick"
minisign -G -W -p "$key" -s "$work/key" >/dev/null
minisign -G -W -p "$work/other.pub" -s "$work/other" >/dev/null

dd() { # A file system in memory may not support direct reads.
    local words=("${@/,direct/}")
    command dd "${words[@]/%conv=notrunc,fsync/conv=notrunc}"
}
progress() { steps+=" $1"; $progress_does; }
has_stick() { [ "$stick_gone" = 0 ]; }

make_root() { # BYTES: a file that begins like a squashfs
    { printf hsqs; head -c $(($1 - 4)) /dev/urandom; } >"$work/root.sqfs"
}
make() { # BOARD VERSION [KEY]
    board/image/update/make_package.sh "$work/root.sqfs" "$1" "$2" 'Kingyo 0.2 (2026-12-01)' "${3:-$work/key}" "$package"
}
sign() { minisign -S -s "$work/key" -m "$package/manifest" -x "$package/manifest.minisig" >/dev/null; }

# A machine that runs slot a with version 5, and an old system in slot b.
fresh() {
    printf 'board vm\nversion 5\nname Kingyo 0.1\nslot a\n' >"$own"
    rm -f "$slots" && truncate -s 1M "$slots" && slots_write "$slots" a - 0
    printf 'hsqs the system before' >"$idle" && truncate -s 12M "$idle"
    cp "$idle" "$work/idle-before" && cp "$slots" "$work/slots-before"
    rm -rf "$package" && cp -r "$work/good" "$package"
    fault='' steps='' progress_does=true stick_gone=0
}
is_untouched() { cmp "$idle" "$work/idle-before" && cmp "$slots" "$work/slots-before"; }
runs() { package_open "$package" && package_check && package_write; }
fails() { # FAULT: the update fails with this fault, and nothing was written.
    ! runs && echo "fault $fault" && [ "$fault" = "$1" ] && is_untouched
}
bad() { # FAULT COMMAND...: COMMAND changes a good package.
    fresh && "${@:2}" && fails "$1"
}

size=$((9 * 1048576 + 4096))
make_root "$size"
make vm 6 && mv "$package" "$work/good"
works() {
    fresh && runs && [ "$name" = 'Kingyo 0.2 (2026-12-01)' ] && slots_read "$slots" && [ "$good$trial$starts" = ab2 ] &&
        command cmp -n "$size" "$idle" "$work/root.sqfs"
}
check 'a good package is written to the idle slot, which gets two starts' works
header_last() { # The order of the writes: chunk 0 last, and its first block at the very end.
    local order
    fresh
    order=$(dd() { case $* in *"of=$idle"*) echo "$*" | sed 's/.*seek=\([0-9]*\).*/\1/; /of=/s/.*/clear/' >>"$work/order" ;; esac
        command dd "${@/,direct/}"; }
        : >"$work/order"; runs && tr '\n' ' ' <"$work/order")
    echo "$order"
    [ "$order" = 'clear 1024 2048 1 0 ' ]
}
check 'the header of the new system is deleted first and written last' header_last

# ---- Each fault, before anything is written
check 'a stick without the folder' bad no-folder rm -r "$package"
check 'a folder without the manifest' bad no-folder rm "$package/manifest"
check 'a folder without the system' bad no-folder rm "$package/root.sqfs"
check 'a package without a signature' bad unsigned rm "$package/manifest.minisig"
check 'a package with an empty signature' bad wrong-key truncate -s 0 "$package/manifest.minisig"
other_key() { make vm 6 "$work/other"; }
check 'a package that is signed with another key' bad wrong-key other_key
altered() { sed -i 's/^version 6/version 7/' "$package/manifest"; }
check 'a manifest that was changed after it was signed' bad wrong-key altered
older() { make vm 4; }
check 'an older version' bad older older
same() { make vm 5; }
check 'the same version' bad same-version same
other_board() { make rpi4 6; }
check 'a package for another board' bad wrong-board other_board
large() { truncate -s $((size - 4096)) "$idle" && cp "$idle" "$work/idle-before"; }
check 'a system that is larger than the slot' bad too-large large
damage() { # OFFSET
    printf x | command dd of="$package/root.sqfs" bs=1 seek="$1" conv=notrunc status=none
}
for at in 4 4194304 $((size - 1)); do
    check "a system whose byte $at is changed" bad damaged damage "$at"
done
check 'a system that is too short' bad damaged truncate -s $((size - 4096)) "$package/root.sqfs"
check 'an empty system' bad damaged truncate -s 0 "$package/root.sqfs"
huge() { head -c 100000 /dev/zero >>"$package/manifest"; }
check 'a manifest that is too large for memory' bad damaged huge
fifo() { rm "$package/manifest" && mkfifo "$package/manifest"; }
check 'a manifest that is a FIFO' bad wrong-key fifo
linked() { mv "$package/manifest" "$work/elsewhere" && ln -s "$work/elsewhere" "$package/manifest"; }
check 'a manifest that is a link' bad damaged linked
linked_root() { mv "$package/root.sqfs" "$work/elsewhere" && ln -s "$work/elsewhere" "$package/root.sqfs"; }
check 'a system that is a link' bad damaged linked_root
signed_as() { # SED: a manifest with a valid signature and invalid contents
    sed -i "$1" "$package/manifest" && sign
}
for edit in '1s/1/2/' '2d' '3s/6/06/' '3s/6/-6/' '3s/6/6x/' '5s/$/1/' '5s/.*/size 0/' '5s/.*/size 99999999999999/' '$d' \
    '$s/$/0/' '6s/./X/' '4s/$/a name that has more letters than a line of the menu has room for/'; do
    check "a signed manifest after the edit $edit" bad damaged signed_as "$edit"
done
trial_runs() { printf 'board vm\nversion 5\nname x\nslot b\n' >"$own" && slots_write "$slots" a b 1 && cp "$slots" "$work/slots-before"; }
check 'a system on trial replaces no good system' bad on-trial trial_runs
canceled() { progress_does=false; }
check 'a page that is closed while the package is checked' bad canceled canceled
pulled() { damage 100 && stick_gone=1; }
check 'a stick that is pulled out while the package is checked' bad pulled pulled

# ---- Faults after the check: the idle slot has no header, and the state starts the running system
is_old() { slots_read "$slots" && [ "$good$trial" = a- ] && [ "$(head -c 4 "$idle" | tr -d '\0')" = '' ]; }
on_write() { # COMMAND: runs COMMAND before the first chunk is written.
    case "$steps" in *writing) $1 ;; esac
}
swaps() { # FAULT COMMAND
    fresh && progress_does="on_write $2" && ! runs && echo "fault $fault, $steps" && [ "$fault" = "$1" ] && is_old
}
other_chunk() { damage 4200000; }
check 'a stick that shows other contents after the check gains nothing' swaps damaged other_chunk
first_chunk() { damage 0; }
check 'the same for the header' swaps damaged first_chunk
gone() { damage 4200000; stick_gone=1; }
check 'a stick that is pulled out while the system is written' swaps pulled gone
new_manifest() { printf 'kingyo-update 1\nboard vm\nversion 9\n' >"$package/manifest"; }
manifest_swap() { fresh && progress_does="on_write new_manifest" && runs && [ "$version" = 6 ]; }
check 'a manifest that changes after the check is not read again' manifest_swap
closes_late() { fresh && progress_does='eval case $steps in *writing*writing) false ;; esac' && ! runs && [ "$fault" = canceled ] && is_old; }
check 'a page that is closed while the system is written' closes_late
forgets() { # A card that confirms a write and does not keep it.
    fresh && ! (dd() { case $* in *"of=$idle"*seek=*) true ;; *) command dd "${@/,direct/}" ;; esac; }
        runs; code=$?; echo "$fault" >"$work/fault"; exit $code) && [ "$(cat "$work/fault")" = card ] && is_old
}
check 'a card that does not keep what was written' forgets

# The power is cut before write number N of all writes to the disk. The machine must start the old system, or the complete
# new system.
cut_at() { # N
    fresh
    (dd() {
        case $* in
            *"of=$idle"* | *"of=$slots"*)
                echo x >>"$work/writes"
                [ "$(wc -l <"$work/writes")" -le "$n" ] || exit 9
                ;;
        esac
        command dd "${@/,direct/}"
    }
    n=$1
    : >"$work/writes"
    runs)
}
cuts() {
    local n code
    for ((n = 0; n < 20; n++)); do
        cut_at "$n"
        code=$?
        slots_read "$slots" || return 1
        echo "cut after $n writes: code $code, $good $trial"
        if [ "$trial" = b ]; then
            [ "$good$starts" = a2 ] && command cmp -n "$size" "$idle" "$work/root.sqfs" && [ "$code" -eq 0 ] && return 0
            return 1
        fi
        [ "$good" = a ] && { [ "$n" -lt 2 ] || [ "$n" -ge 6 ] || is_old; } || return 1
    done
    return 1
}
check 'a power cut before each write leaves the old system or the complete new one' cuts

# ---- make update
update() { # FOLDER: Makes an update of an image whose system has the files of FOLDER.
    local image=$work/build/image/vm
    rm -rf "$work/build" && mkdir -p "$image" && mksquashfs "$1" "$image/root.sqfs" -quiet -no-progress >/dev/null &&
        printf 'board vm\nversion 7\nname Kingyo 0.3\n' >"$image/update-version" &&
        command make -s BUILD="$work/build" BOARD=vm SIGN_KEY="$work/key" update 2>&1
}
signs() {
    mkdir -p "$work/system/usr/lib/kingyo" && cp "$key" "$work/system/usr/lib/kingyo/update.pub" &&
        update "$work/system" && [ -s "$work/build/image/vm/kingyo-update/manifest.minisig" ]
}
refuses() {
    mkdir -p "$work/bare/usr" && ! update "$work/bare" >"$work/said" &&
        grep -qx 'update: the image takes no updates; make image with UPDATE_KEY=FILE.pub first' "$work/said"
}
if command -v mksquashfs >/dev/null; then
    check 'make update signs the system of the last image' signs
    check 'make update rejects an image without a key for updates' refuses
else
    skip 'make update' 'mksquashfs is not installed; board/setup.sh vm installs it'
fi
echo "1..$count"
