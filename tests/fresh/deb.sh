#!/bin/bash
# deb.sh [RELEASE] -- installs, upgrades, disables, removes, reinstalls and purges the packages in
# a minimal root (default bookworm), and checks takings and configuration after each step.
# The test covers only dpkg. The libraries that the programs need are not installed in the root
# (300 MB). No systemd runs in the root, so services are enabled and disabled, but not started.
#
# With ARCH=arm64, the packages are cross-compiled, and the root is one of Debian 13 for that
# processor with the libraries. The installed programs then also run, emulated by qemu.
#
# The root is kept as BUILD/fresh/deb-RELEASE.tar for a week. Needs root, mmdebstrap and this
# machine's mirror. Speaks TAP.
set -u
cd "$(dirname "$0")/../.." || exit 1
arch=${ARCH:-}
release=${1:-$([ -n "$arch" ] && echo trixie || echo bookworm)}
if [ "$(id -u)" -ne 0 ]; then
    echo 'test-deb: making a root file system needs root; please run: sudo make test-deb' >&2
    exit 1
fi
[ -z "$arch" ] || board/deb/emulate.sh "$arch" || exit 1
. tests/fresh/root.sh
make_root "deb-$release${arch:+-$arch}" "$release" "${arch:-$(dpkg --print-architecture)}" "${arch:+$libraries}" || exit 1

inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C "$@"; }
dpkg_inside() { inside dpkg --force-depends "$@"; }
debs() { # VERSION: Makes both packages and copies them into the root.
    if [ -n "$arch" ]; then
        VERSION=$1 BUILD=$build board/deb/cross.sh "$arch" deb && cp "$build"/deb/kingyo{,-kiosk}_"$1"_*.deb "$root/tmp/"
        return
    fi
    mkdir -p "$work/build-$1"
    ln -s "$build/kingyo" "$build/kingyoctl" "$build/man" "$work/build-$1/"
    VERSION=$1 BUILD=$work/build-$1 board/deb/deb.sh && cp "$work/build-$1"/deb/*.deb "$root/tmp/"
}
# Installs one package after another in the order of apt. The option force is needed, because dpkg
# would refuse this order.
both() {
    dpkg_inside -i "/tmp/kingyo_$1_${arch:-$(dpkg --print-architecture)}.deb" && dpkg_inside -i "/tmp/kingyo-kiosk_$1_all.deb"
}
check 'the packages of the earlier version are built' debs 0.0.8
check 'the packages of the later version are built' debs 0.0.9

data=$root/var/lib/kingyo conf=$root/etc/kingyo/kingyo.conf
wants=$root/etc/systemd/system/multi-user.target.wants/kingyo.service
is_kept() { [ "$(cat "$data/kingyo.db")" = takings ]; }

check 'the packages can be installed' both 0.0.8
check 'the installation creates the user' inside id kingyo
is_owned() { [ "$(inside stat -c '%U %G %a' /var/lib/kingyo)" = 'kingyo kingyo 750' ]; }
check 'the data folder belongs only to the user' is_owned
check 'the installation enables the service' test -L "$wants"
check 'the installation writes the configuration' test -s "$conf"
manual() { inside test -s /usr/share/man/man6/kingyo.6.gz || grep -q path-exclude=/usr/share/man "$root"/etc/dpkg/dpkg.cfg.d/*; }
check 'the installation includes the manual if the root keeps manuals' manual

if [ -n "$arch" ]; then
    libraries_found() { inside ldd /usr/bin/kingyo /usr/bin/kingyoctl && ! inside ldd /usr/bin/kingyo /usr/bin/kingyoctl | grep 'not found'; }
    check 'the programs find all libraries' libraries_found
    hash_of() { sed -E 's/.*"state_hash": "([0-9a-f]+)".*/\1/'; }
    same_hash() { [ "$(inside kingyoctl tank --seconds 20 --json | hash_of)" = "$("$build/kingyoctl" tank --seconds 20 --json | hash_of)" ]; }
    check 'the tank has the hash of this machine after 20 s' same_hash
    plays() { inside kingyo --demo 5 --window 320x240 --shots /tmp/shots && [ -s "$root/tmp/shots/contact-sheet.png" ]; }
    check 'the game starts and draws pictures' plays
fi

echo takings >"$data/kingyo.db"
echo 'price = 2' >"$conf"
check 'an upgrade succeeds without a question' both 0.0.9
check 'an upgrade keeps the takings' is_kept
check 'an upgrade keeps the configuration' grep -qx 'price = 2' "$conf"
check 'an upgrade keeps the service enabled' test -L "$wants"
inside systemctl disable kingyo.service >"$work/disabled" 2>&1
stays_off() { both 0.0.8 && both 0.0.9 && [ ! -e "$wants" ]; }
check 'an upgrade keeps a disabled service disabled' stays_off
inside systemctl enable kingyo.service >"$work/enabled" 2>&1
check 'the packages can be removed' dpkg_inside -r kingyo-kiosk kingyo
check 'a removal keeps the takings' is_kept
check 'a removal keeps the configuration' grep -qx 'price = 2' "$conf"
no_service() { [ ! -e "$root/usr/lib/systemd/system/kingyo.service" ] && [ ! -e "$root/usr/bin/kingyo" ]; }
check 'a removal deletes the programs and the service' no_service
check 'the packages can be installed again' both 0.0.9
check 'a second installation keeps the service enabled' test -L "$wants"
not_masked() { [ ! -L "$root/etc/systemd/system/kingyo.service" ]; }
check 'a second installation leaves the service startable' not_masked
check 'the packages can be purged without a question' dpkg_inside -P kingyo-kiosk kingyo
check 'a purge keeps the takings' is_kept
check 'a purge deletes the configuration' test ! -e "$root/etc/kingyo"
# Everything is removed except the takings, the user and the files that systemd wrote for the user.
nothing_left() {
    find "$root" -xdev -name '*kingyo*' ! -path "$root/tmp/*" ! -path "$data*" | grep . && return 1
    return 0
}
check 'a purge leaves nothing else' nothing_left
echo "1..$count"
exit $failed
