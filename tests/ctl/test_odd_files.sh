#!/bin/bash
# test_odd_files.sh -- every option and argument that names an input file: a device, a FIFO without
# a writer, a folder, an endless file of /proc and a huge sparse file each give one line and exit
# code 65 or 74 within seconds. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
limit_s=20 # The limit in seconds allows for a loaded machine. A command that hangs is killed.
pad=tests/hid/good/descriptors/006-blaze-joypad.hid
mkdir "$work/odd" "$work/plain"
# The names have the suffixes that the commands expect: a species by its suffix, an import by its
# format.
for suffix in '' .txt .kfish .glb .obj .graph; do
    ln -s /dev/zero "$work/odd/zero$suffix"
    ln -s /proc/self/pagemap "$work/odd/endless$suffix"
    mkfifo "$work/odd/pipe$suffix"
    mkdir "$work/odd/folder$suffix"
    truncate -s 1T "$work/odd/sparse$suffix" 2>/dev/null || truncate -s 4G "$work/odd/sparse$suffix"
done

# PROGRAM and arguments, with FILE in place of the odd file.
readers=$(cat <<END
$ctl config check FILE
$ctl doctor --config FILE
$ctl tank --place FILE --fish 1 --seconds 1
$ctl tank --poi-path FILE --seconds 1
$ctl play --bot FILE --round-s 10
$ctl hid describe FILE
$ctl hid map FILE
$ctl hid decode FILE $work/plain/reports.tsv
$ctl hid decode $pad FILE
$ctl hid watch FILE --descriptor $pad --seconds 5
$ctl hid watch $work/plain/raw --descriptor FILE
$ctl status --file FILE
$ctl replay info FILE
$ctl replay verify FILE
$ctl backup --restore FILE --data $work/plain
$ctl morph growth FILE.txt
$ctl morph weights FILE.kfish
$ctl morph import $work/out.kfish FILE.txt
$ctl morph import $work/out.kfish FILE.glb
$ctl morph import $work/out.kfish FILE.obj FILE.obj FILE.obj
$build/kingyo --config FILE --demo 5
$build/kingyo --replay FILE
$build/kingyo-poi watch --simulate --seconds 1 --config FILE
END
)
printf 'id\tnumber\thex\n' >"$work/plain/reports.tsv"
: >"$work/plain/raw"

refused() { # WORDS...: One line on standard error, exit code 65 or 74, within limit_s.
    local code
    SDL_VIDEODRIVER=dummy timeout --kill-after=2 $limit_s "$@" >"$work/out" 2>"$work/err" </dev/null
    code=$?
    [ $code -eq 65 ] || [ $code -eq 74 ] || { echo "exit $code: $*"; head -3 "$work/err"; return 1; }
    [ "$(wc -l <"$work/err")" -le 1 ] && [ -s "$work/err" ] || { echo "not one line: $*"; head -3 "$work/err"; return 1; }
}
all_refuse() { # KIND: Every reader refuses the odd file of this KIND.
    local words bad=0
    while IFS= read -r words; do
        # shellcheck disable=SC2086
        refused ${words//FILE/$work/odd/$1} || bad=1
    done <<<"$readers"
    return $bad
}
error_contains() { # WORDS KIND PROGRAM...: The error line contains WORDS. FILE in the arguments stands for the odd file of KIND.
    local expected=$1 kind=$2
    shift 2
    refused "${@//FILE/$work/odd/$kind}"
    cat "$work/err"
    grep -qF "$expected" "$work/err"
}
database() { # A FIFO, a folder or a device in place of kingyo.db.
    local kind bad=0
    for kind in pipe folder zero; do
        rm -rf "$work/data" && mkdir "$work/data" || return 1
        case $kind in
        pipe) mkfifo "$work/data/kingyo.db" ;;
        folder) mkdir "$work/data/kingyo.db" ;;
        zero) ln -s /dev/zero "$work/data/kingyo.db" ;;
        esac
        refused "$ctl" scores --data "$work/data" || bad=1
        refused "$ctl" audits --data "$work/data" || bad=1
        refused "$ctl" backup "$work/copy.db" --data "$work/data" || bad=1
        timeout $limit_s "$ctl" doctor --data "$work/data" >/dev/null 2>&1 </dev/null
        [ $? -le 1 ] || bad=1
        # A restore renames the odd file and writes the database.
        timeout $limit_s "$ctl" backup --restore tests/unit/platform/store/files/version-6.db --data "$work/data" && [ -f "$work/data/kingyo.db" ] || bad=1
    done
    return $bad
}
learned() { # The doctor reports a FIFO that lies among the controller mappings.
    mkdir -p "$work/learned/pois" && mkfifo "$work/learned/pois/a.poi" &&
        timeout $limit_s "$ctl" doctor --data "$work/learned" >"$work/out" 2>&1 </dev/null
    [ $? -le 1 ] && grep -q 'a.poi' "$work/out"
}
links() { # A symbolic link to a regular file is read like the file.
    "$ctl" config defaults >"$work/plain/mine.conf" && ln -s mine.conf "$work/plain/link.conf" &&
        "$ctl" config check "$work/plain/link.conf" &&
        ln -s "$PWD/$pad" "$work/plain/link.hid" && "$ctl" hid describe "$work/plain/link.hid" >/dev/null
}
writes_nowhere() { # An output to a FIFO without a reader does not block either.
    refused "$ctl" tank --fish 1 --seconds 1 --trace "$work/odd/pipe" && [ -p "$work/odd/pipe" ]
}
by_input() { # Standard input is read if it is a regular file.
    "$ctl" config defaults >"$work/plain/in.conf" && "$ctl" config check /dev/stdin <"$work/plain/in.conf"
}

echo 1..13
check 'an endless device is refused by every command' all_refuse zero
check 'a FIFO without a writer is refused by every command' all_refuse pipe
check 'a folder is refused by every command' all_refuse folder
check 'a huge sparse file is refused by every command' all_refuse sparse
check 'an endless file of /proc is refused by every command' all_refuse endless
check 'the error names the wrong file type' error_contains 'is not a regular file' pipe "$ctl" config check FILE
check 'the error names the size limit' error_contains 'is larger than 64 MiB' sparse "$ctl" tank --place FILE --fish 1
check 'the error names a pipe without a writer' error_contains 'no process writes into this pipe' pipe "$ctl" hid watch FILE --descriptor $pad
check 'a database of another file type is refused by every command' database
check 'a FIFO among the controller mappings does not block doctor' learned
check 'a symbolic link is followed' links
check 'a trace to a FIFO without a reader is refused' writes_nowhere
check 'standard input from a regular file is read' by_input
