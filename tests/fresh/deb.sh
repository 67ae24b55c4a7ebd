#!/bin/bash
# deb.sh [RELEASE] -- the packages' life in a minimal root (bookworm): installed, upgraded, turned off,
# removed, installed again, purged; and what becomes of takings and configuration at each step.
#
# dpkg's own part of it: the libraries that the programs ask for are left out of the root (300 MB). No
# systemd runs in there, so services are turned on and off, not started. The root is kept as
# BUILD/fresh/deb-RELEASE.tar for a week. Needs root, mmdebstrap and this machine's mirror. Speaks TAP.
set -u
cd "$(dirname "$0")/../.." || exit 1
release=${1:-bookworm}
build=$(realpath "${BUILD:-build}")
if [ "$(id -u)" -ne 0 ]; then
    echo 'test-deb: making a root file system needs root; please run: sudo make test-deb' >&2
    exit 1
fi
top=$(mktemp -d /var/tmp/kingyo-deb-XXXXXX)
root=$top/root
finish() {
    mountpoint -q "$root/proc" && umount "$root/proc"
    rm -rf --one-file-system "$top"
}
trap finish EXIT
tar=$build/fresh/deb-$release.tar
mkdir -p "$build/fresh" "$root"
if [ -z "$(find "$tar" -mtime -7 2>/dev/null)" ]; then
    mmdebstrap --quiet --variant=minbase --include=systemd,udev,init-system-helpers "$release" "$tar" || exit 1
fi
tar -C "$root" -xf "$tar" --exclude='./dev/*' || exit 1
mount -t proc proc "$root/proc" || exit 1 # systemd-tmpfiles reaches files through it.

count=0 failed=0
check() { # TITLE COMMAND...
    local title=$1
    shift
    count=$((count + 1))
    if "$@" >"$top/said" 2>&1 </dev/null; then echo "ok $count - $title"; else
        echo "not ok $count - $title"
        sed 's/^/# /' "$top/said"
        failed=1
    fi
}
inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C "$@"; }
dpkg_inside() { inside dpkg --force-depends "$@"; }
debs() { # VERSION: makes both, and puts them into the root.
    mkdir -p "$top/build-$1"
    ln -s "$build/kingyo" "$build/kingyoctl" "$build/man" "$top/build-$1/"
    VERSION=$1 BUILD=$top/build-$1 board/deb/deb.sh && cp "$top/build-$1"/deb/*.deb "$root/tmp/"
}
both() { # One after the other, as apt orders them: forced, dpkg would not.
    dpkg_inside -i "/tmp/kingyo_$1_$(dpkg --print-architecture).deb" && dpkg_inside -i "/tmp/kingyo-kiosk_$1_all.deb"
}
check 'two versions are made' debs 0.0.8
check 'the later one' debs 0.0.9

data=$root/var/lib/kingyo conf=$root/etc/kingyo/kingyo.conf
wants=$root/etc/systemd/system/multi-user.target.wants/kingyo.service
is_kept() { [ "$(cat "$data/kingyo.db")" = takings ]; }

check 'they install' both 0.0.8
check 'the user is there' inside id kingyo
is_his() { [ "$(inside stat -c '%U %G %a' /var/lib/kingyo)" = 'kingyo kingyo 750' ]; }
check 'the data folder is his alone' is_his
check 'the service is on' test -L "$wants"
check 'the configuration is there' test -s "$conf"
manual() { inside test -s /usr/share/man/man6/kingyo.6.gz || grep -q path-exclude=/usr/share/man "$root"/etc/dpkg/dpkg.cfg.d/*; }
check 'and the manual, where a root keeps manuals' manual

echo takings >"$data/kingyo.db"
echo 'price = 2' >"$conf"
check 'an upgrade goes through, asking nothing' both 0.0.9
check 'and leaves the takings' is_kept
check 'and the configuration' grep -qx 'price = 2' "$conf"
check 'and the service on' test -L "$wants"
inside systemctl disable kingyo.service >"$top/disabled" 2>&1
stays_off() { both 0.0.8 && both 0.0.9 && [ ! -e "$wants" ]; }
check 'what its operator turned off stays off' stays_off
inside systemctl enable kingyo.service >"$top/enabled" 2>&1
check 'it is removed' dpkg_inside -r kingyo-kiosk kingyo
check 'the takings stay' is_kept
check 'so does the configuration' grep -qx 'price = 2' "$conf"
no_service() { [ ! -e "$root/usr/lib/systemd/system/kingyo.service" ] && [ ! -e "$root/usr/bin/kingyo" ]; }
check 'the programs and the service are gone' no_service
check 'it is installed again' both 0.0.9
check 'and on, as it was' test -L "$wants"
not_masked() { [ ! -L "$root/etc/systemd/system/kingyo.service" ]; }
check 'and can be started' not_masked
check 'it is purged, asking nothing' dpkg_inside -P kingyo-kiosk kingyo
check 'the takings stay even then' is_kept
check 'the configuration is gone' test ! -e "$root/etc/kingyo"
nothing_left() { # But for the takings, the user and what systemd wrote of him.
    find "$root" -xdev -name '*kingyo*' ! -path "$root/tmp/*" ! -path "$data*" | grep . && return 1
    return 0
}
check 'nothing else is left' nothing_left
echo "1..$count"
exit $failed
