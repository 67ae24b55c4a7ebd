#!/bin/bash
# test_service.sh -- the files that `make install` installs, the permissions of the service, the
# files that an uninstall keeps. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$work/root
installer() { DESTDIR=$root PREFIX=${prefix:-/usr} BUILD=$build board/install.sh "$@"; }
unit=$root/usr/lib/systemd/system/kingyo.service

# ---- Installing
check 'make install succeeds' installer install
everything() { # The installed files are exactly the rows of the list.
    local rows files
    rows=$(grep -cE '^kingyo' board/files.txt)
    files=$(find "$root" -type f | wc -l)
    echo "$rows rows, $files files"
    [ "$rows" -eq "$files" ]
}
check 'every row of the list is installed' everything
runs() { "$root/usr/bin/kingyo" --version && "$root/usr/bin/kingyoctl" --version; }
check 'the installed programs run' runs
no_marks() { ! grep -rIn '@PREFIX@\|@BUILD@' "$root" --exclude-dir=bin; }
check 'no placeholder is left in an installed file' no_marks
modes() { ! find "$root" -type f -perm /022 | grep . && [ "$(stat -c %a "$root/usr/bin/kingyo")" = 755 ] && [ "$(stat -c %a "$unit")" = 644 ]; }
check 'programs have mode 755 and texts 644, and nothing is writable for everybody' modes
all_listed() { # Every file of these folders needs a row, because it would otherwise never be installed.
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
check 'the service uses another prefix' elsewhere

# ---- The manual
for page in man6/kingyo.6 man1/kingyoctl.1 man5/kingyo.conf.5; do
    # shellcheck disable=SC2317
    formats() { man --warnings -E UTF-8 -l -Tutf8 -Z "$root/usr/share/man/$page" 2>&1 >"$work/formatted" | grep . && return 1; [ -s "$work/formatted" ]; }
    if command -v man >"$work/which"; then check "$page: man reports nothing" formats; else
        skip "$page: man reports nothing" 'no man'
    fi
    # The pages it refers to may not be installed here, and the order of the sections is a matter
    # of style.
    # shellcheck disable=SC2317
    lints() { mandoc -Tlint -W style "$root/usr/share/man/$page" | grep -v 'referenced manual not found' | grep . && return 1; return 0; }
    if command -v mandoc >"$work/which"; then check "$page: mandoc reports nothing" lints; else
        skip "$page: mandoc reports nothing" 'no mandoc'
    fi
done
complete() { # The pages contain each key of the file, each option of the kiosk and each command.
    local word
    for word in $("$build/kingyoctl" config defaults | sed -nE 's/^#([a-z0-9-]+) =.*/\1/p'); do
        grep -qx ".It Ic $word" "$root/usr/share/man/man5/kingyo.conf.5" || { echo "no $word"; return 1; }
    done
    for word in $("$build/kingyo" --help | sed -nE 's/^  --([a-z-]+).*/\1/p'); do
        grep -qE "^\.It Fl -$word( |$)" "$root/usr/share/man/man6/kingyo.6" || { echo "no --$word"; return 1; }
    done
    for word in $("$build/kingyoctl" --help | sed -nE 's/^  ([a-z]+) .*/\1/p'); do
        grep -qx ".Ss kingyoctl $word" "$root/usr/share/man/man1/kingyoctl.1" || { echo "no $word"; return 1; }
    done
}
check 'the pages contain every key, option and command' complete
has_range() { grep -A3 -x '.It Ic price' "$root/usr/share/man/man5/kingyo.conf.5" | grep -x 'Expects 1 to 20.'; }
check 'the page gives the range of a key' has_range

# ---- The service
has() { grep -qxF "$1" "$unit" || { echo "no line '$1'"; return 1; }; }
for line in Type=notify WatchdogSec=10s TimeoutAbortSec=10s Restart=always StartLimitIntervalSec=1h StartLimitBurst=40 User=kingyo LimitRTPRIO=1; do
    check "the service has $line" has "$line"
done
no_seat() { ! grep -E '^(PAMName|TTYPath|StandardInput)=' "$unit"; }
check 'the service needs no seat and no terminal' no_seat
if systemd-analyze security --help 2>/dev/null | grep -q -- --offline; then
    exposure() { # At most 1.5, which systemd counts in tenths.
        systemd-analyze security --offline=true --no-pager --threshold=15 "$unit"
    }
    check 'the exposure level of systemd is at most 1.5' exposure
    open() { # The check must detect a service without a line of its sandbox.
        sed '/^RestrictNamespaces\|^CapabilityBoundingSet\|^SystemCallFilter/d' "$unit" >"$work/kingyo.service"
        ! systemd-analyze security --offline=true --no-pager --threshold=15 "$work/kingyo.service"
    }
    check 'a weakened sandbox exceeds the exposure level' open
    # shellcheck disable=SC2317
    sound() { # The program is not in the root of this machine, so only the text of the unit is checked.
        sed "s#=/usr/bin/#=$(realpath "$root")/usr/bin/#; /^Documentation/d" "$unit" >"$work/kingyo.service"
        systemd-analyze verify --man=no "$work/kingyo.service" >"$work/verified" 2>&1
        ! grep kingyo "$work/verified"
    }
    check 'systemd-analyze finds no mistake in the unit' sound
else
    for title in 'the exposure level of systemd is at most 1.5' 'systemd-analyze finds no mistake in the unit'; do
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
    check 'the data folder is accessible only to the kiosk' folder
else
    skip 'the data folder is accessible only to the kiosk' 'there is no systemd-sysusers'
fi

# ---- Uninstalling
keeps() {
    mkdir -p "$root/var/lib/kingyo" && echo takings >"$root/var/lib/kingyo/kingyo.db"
    installer uninstall || return 1
    find "$root" -path "$root/etc/kingyo" -o -type f -print | grep -v -e /var/lib/kingyo/kingyo.db -e "$root/etc/"
    [ "$(find "$root/usr" -type f | wc -l)" -eq 0 ] && [ -e "$root/var/lib/kingyo/kingyo.db" ]
}
check 'make uninstall removes every file and keeps the data' keeps
check 'a second uninstall succeeds' installer uninstall
conf_stays() {
    installer install && [ -e "$root/etc/kingyo/kingyo.conf" ] && echo 'price = 2' >"$root/etc/kingyo/kingyo.conf" &&
        installer install && grep -qx 'price = 2' "$root/etc/kingyo/kingyo.conf" &&
        installer uninstall && grep -qx 'price = 2' "$root/etc/kingyo/kingyo.conf"
}
check "the operator's configuration survives install and uninstall" conf_stays
echo "1..$count"
