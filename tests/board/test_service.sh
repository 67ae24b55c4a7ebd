#!/bin/bash
# test_service.sh -- what `make install` puts where, what the service may do, what an uninstall leaves. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$work/root
installer() { DESTDIR=$root PREFIX=${prefix:-/usr} BUILD=$build board/install.sh "$@"; }
unit=$root/usr/lib/systemd/system/kingyo.service

# ---- Installing
check 'it installs' installer install
everything() { # And nothing else: as many files as rows.
    local rows files
    rows=$(grep -cE '^kingyo' board/files.txt)
    files=$(find "$root" -type f | wc -l)
    echo "$rows rows, $files files"
    [ "$rows" -eq "$files" ]
}
check 'every row of the list is a file' everything
runs() { "$root/usr/bin/kingyo" --version && "$root/usr/bin/kingyoctl" --version; }
check 'the programs run from there' runs
no_marks() { ! grep -rIn '@PREFIX@\|@BUILD@' "$root" --exclude-dir=bin; }
check 'no mark is left unfilled' no_marks
modes() { ! find "$root" -type f -perm /022 | grep . && [ "$(stat -c %a "$root/usr/bin/kingyo")" = 755 ] && [ "$(stat -c %a "$unit")" = 644 ]; }
check 'programs are 755, texts 644, nothing is for everybody to write' modes
all_listed() { # What lies in these folders without a row would never reach a machine.
    local file
    for file in board/kiosk/* board/systemd/* board/udev/* board/sysusers/* board/tmpfiles/*; do
        grep -q " $file " board/files.txt || { echo "$file is in no row"; return 1; }
    done
}
check 'every file that is meant to be installed is listed' all_listed
bad_prefix() { prefix='/opt/my stall' installer install; [ $? -eq 2 ]; }
check 'a prefix with a space is refused' bad_prefix
elsewhere() {
    (root=$work/local prefix=/usr/local; installer install) &&
        grep -q '^ExecStart=/usr/local/bin/kingyo ' "$work/local/usr/local/lib/systemd/system/kingyo.service"
}
check 'another prefix is the service'\''s, too' elsewhere

# ---- The manual
for page in man6/kingyo.6 man1/kingyoctl.1 man5/kingyo.conf.5; do
    # shellcheck disable=SC2317
    formats() { man --warnings -E UTF-8 -l -Tutf8 -Z "$root/usr/share/man/$page" 2>&1 >"$work/formatted" | grep . && return 1; [ -s "$work/formatted" ]; }
    if command -v man >"$work/which"; then check "$page: man has nothing to complain of" formats; else
        skip "$page: man has nothing to complain of" 'no man'
    fi
    # What it refers to may not be installed here; the section's order is a matter of taste.
    # shellcheck disable=SC2317
    lints() { mandoc -Tlint -W style "$root/usr/share/man/$page" | grep -v 'referenced manual not found' | grep . && return 1; return 0; }
    if command -v mandoc >"$work/which"; then check "$page: mandoc finds nothing, not even of style" lints; else
        skip "$page: mandoc finds nothing, not even of style" 'no mandoc'
    fi
done
complete() { # Each key of the file, each option of the kiosk, each command.
    local word
    for word in $("$build/kingyoctl" config defaults | sed -nE 's/^#([a-z0-9-]+) =.*/\1/p'); do
        grep -qx ".It Ic $word" "$root/usr/share/man/man5/kingyo.conf.5" || { echo "no $word"; return 1; }
    done
    for word in $("$build/kingyo" --help | sed -nE 's/^  --([a-z]+).*/\1/p'); do
        grep -qE "^\.It Fl -$word( |$)" "$root/usr/share/man/man6/kingyo.6" || { echo "no --$word"; return 1; }
    done
    for word in $("$build/kingyoctl" --help | sed -nE 's/^  ([a-z]+) .*/\1/p'); do
        grep -qx ".Ss kingyoctl $word" "$root/usr/share/man/man1/kingyoctl.1" || { echo "no $word"; return 1; }
    done
}
check 'every key, option and command has its place in them' complete
has_range() { grep -A3 -x '.It Ic price' "$root/usr/share/man/man5/kingyo.conf.5" | grep -x 'Expects 1 to 20.'; }
check 'a key with its range' has_range

# ---- The service
has() { grep -qxF "$1" "$unit" || { echo "no line '$1'"; return 1; }; }
for line in Type=notify WatchdogSec=10s TimeoutAbortSec=10s Restart=always StartLimitIntervalSec=1h StartLimitBurst=40 User=kingyo LimitRTPRIO=1; do
    check "the service says $line" has "$line"
done
no_seat() { ! grep -E '^(PAMName|TTYPath|StandardInput)=' "$unit"; }
check 'and needs no seat and no terminal' no_seat
if systemd-analyze security --help 2>/dev/null | grep -q -- --offline; then
    exposure() { # At most 1.5, in tenths as systemd counts them.
        systemd-analyze security --offline=true --no-pager --threshold=15 "$unit"
    }
    check 'systemd calls its exposure 1.5 or lower' exposure
    open() { # That the judge can say no: the same service without a line of its sandbox.
        sed '/^RestrictNamespaces\|^CapabilityBoundingSet\|^SystemCallFilter/d' "$unit" >"$work/kingyo.service"
        ! systemd-analyze security --offline=true --no-pager --threshold=15 "$work/kingyo.service"
    }
    check 'and would not without capabilities, calls and namespaces shut' open
    # shellcheck disable=SC2317
    sound() { # Its program is not in this machine's root: only its words are judged.
        sed "s#=/usr/bin/#=$(realpath "$root")/usr/bin/#; /^Documentation/d" "$unit" >"$work/kingyo.service"
        systemd-analyze verify --man=no "$work/kingyo.service" >"$work/verified" 2>&1
        ! grep kingyo "$work/verified"
    }
    check 'systemd finds no mistake in it' sound
else
    for title in 'systemd calls its exposure 1.5 or lower' 'systemd finds no mistake in it'; do
        skip "$title" 'no systemd-analyze that judges files (systemd 250 brought it)'
    done
fi
if command -v systemd-sysusers >"$work/which"; then
    # shellcheck disable=SC2317
    folder() {
        mkdir -p "$root/etc" "$root/var/lib" "$root/var/cache" && systemd-sysusers --root="$root" kingyo.conf || return 1
        [ "$(id -u)" -eq 0 ] || return 0 # Giving a folder away is root's.
        systemd-tmpfiles --root="$root" --create kingyo.conf || return 1
        local id
        id=$(awk -F: '$1 == "kingyo" { print $3 }' "$root/etc/passwd")
        [ "$(stat -c '%u %a' "$root/var/lib/kingyo")" = "$id 750" ]
    }
    check 'the data folder is the kiosk'\''s alone' folder
else
    skip 'the data folder is the kiosk'\''s alone' 'there is no systemd-sysusers'
fi

# ---- Taking it away
keeps() {
    mkdir -p "$root/var/lib/kingyo" && echo takings >"$root/var/lib/kingyo/kingyo.db"
    installer uninstall || return 1
    find "$root" -path "$root/etc/kingyo" -o -type f -print | grep -v -e /var/lib/kingyo/kingyo.db -e "$root/etc/"
    [ "$(find "$root/usr" -type f | wc -l)" -eq 0 ] && [ -e "$root/var/lib/kingyo/kingyo.db" ]
}
check 'an uninstall takes every file and leaves the takings' keeps
check 'a second one is no mistake' installer uninstall
conf_stays() {
    installer install && [ -e "$root/etc/kingyo/kingyo.conf" ] && echo 'price = 2' >"$root/etc/kingyo/kingyo.conf" &&
        installer install && grep -qx 'price = 2' "$root/etc/kingyo/kingyo.conf" &&
        installer uninstall && grep -qx 'price = 2' "$root/etc/kingyo/kingyo.conf"
}
check 'what the operator wrote outlives both' conf_stays
echo "1..$count"
