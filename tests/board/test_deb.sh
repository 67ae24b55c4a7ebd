#!/bin/bash
# test_deb.sh -- the Debian packages: what is in them, the same bytes again, what their scripts do. Speaks TAP.
#
# Their scripts run here with commands that only write down that they were called; tests/fresh/deb.sh
# installs, upgrades, removes and purges them in a Debian root.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
cd "$(dirname "$0")/../.." || exit 1
build=$(realpath "$build")
if ! command -v dpkg-shlibdeps >/dev/null; then
    echo '1..0 # skip no dpkg-shlibdeps (package dpkg-dev)'
    exit 0
fi
# A build folder of its own: only the programs are taken from the real one.
mkdir "$work/build"
ln -s "$build/kingyo" "$build/kingyoctl" "$work/build/"
[ -d "$build/man" ] && ln -s "$build/man" "$work/build/"
export LEVEL=1 # Whatever the packing, it is the same for both.
make_debs() { BUILD=$work/build board/deb/deb.sh >"$work/names"; }
check 'two packages are made' make_debs
check 'they have names' grep -c . "$work/names"
for package in kingyo kingyo-kiosk; do
    mkdir -p "$work/$package" "$work/scripts-$package"
    file=$(ls "$work/build/deb/${package}"_*.deb)
    dpkg-deb -x "$file" "$work/$package"
    dpkg-deb -e "$file" "$work/scripts-$package"
done

# ---- What is in them
all_rows() { # Each row's file in its package, and in no other.
    local package to other
    awk '/^kingyo/ { print $1, $4 }' board/files.txt | while read -r package to; do
        other=kingyo
        [ "$package" = kingyo ] && other=kingyo-kiosk
        to=${to/@PREFIX@//usr}
        compgen -G "$work/$package$to*" >/dev/null && ! compgen -G "$work/$other$to*" >/dev/null || { echo "$to"; exit 1; }
    done
}
check 'every row of the list is in its package' all_rows
of_root() { ! dpkg-deb -c "$1" | awk '{ print $2 }' | grep -v '^root/root$'; }
check 'everything in it is root'\''s' of_root "$work"/build/deb/kingyo_*.deb
sums() { (cd "$work/$1" && md5sum --quiet -c "$work/scripts-$1/md5sums") && ! grep -E '  /|DEBIAN' "$work/scripts-$1/md5sums"; }
check 'the sums are those of its files' sums kingyo
check 'also of the kiosk'\''s' sums kingyo-kiosk
depends() { dpkg-deb -f "$work"/build/deb/kingyo_*.deb Depends | grep libc6 | grep libsdl2-2.0-0 | grep libsqlite3-0 | grep libusb-1.0-0; }
check 'the libraries that the programs are linked with are asked for' depends
same_version() { [ "$(dpkg-deb -f "$1" Version)" = "$("$build/kingyo" --version | cut -d' ' -f2)" ]; }
check 'its version is the program'\''s' same_version "$work"/build/deb/kingyo_*.deb
newest_change() { # dpkg's own parser reads the changelog that was made from CHANGELOG.md.
    zcat "$work/kingyo/usr/share/doc/kingyo/changelog.gz" >"$work/changelog" &&
        [ "$(dpkg-parsechangelog -l "$work/changelog" -S Version)" = "$("$build/kingyo" --version | cut -d' ' -f2)" ] &&
        dpkg-parsechangelog -l "$work/changelog" -S Changes | grep '^  \*' >/dev/null
}
if command -v dpkg-parsechangelog >/dev/null; then
    check 'the newest entry of the changelog is of this version' newest_change
else
    skip 'the newest entry of the changelog is of this version' 'no dpkg-parsechangelog'
fi
conffile() { grep -qx /etc/kingyo/kingyo.conf "$work/scripts-kingyo/conffiles"; }
check 'the configuration is the operator'\''s: dpkg asks before it writes over it' conffile
no_takings() { ! find "$work/kingyo" "$work/kingyo-kiosk" -path '*/var/*' | grep .; }
check 'no package owns the data folder' no_takings
again() { # An hour later by every clock, under another umask, in another folder.
    cp -r "$work/build/deb" "$work/first" && find "$work/build" -name '*.deb' -delete || return 1
    mkdir "$work/elsewhere" && cp -P "$work/build/kingyo" "$work/build/kingyoctl" "$work/elsewhere/" || return 1
    [ -e "$work/build/man" ] && cp -P "$work/build/man" "$work/elsewhere/"
    (umask 077 && TZ=Asia/Tokyo LC_ALL=C BUILD=$work/elsewhere board/deb/deb.sh) || return 1
    for file in "$work"/first/*.deb; do
        cmp "$file" "$work/elsewhere/deb/$(basename "$file")" || return 1
    done
}
check 'made again they are the same to the byte' again
if command -v lintian >/dev/null; then
    judged() { lintian --allow-root --fail-on error,warning "$work"/first/*.deb; }
    check 'lintian finds no error and no warning' judged
else
    skip 'lintian finds no error and no warning' 'no lintian'
fi

# ---- What their scripts do
mkdir "$work/bin"
for command in systemd-sysusers systemd-tmpfiles udevadm systemctl deb-systemd-helper deb-systemd-invoke rm; do
    printf '#!/bin/sh\necho "%s $*" >>"%s/calls"\n' $command "$work" >"$work/bin/$command"
done
chmod +x "$work/bin"/*
script() { # PACKAGE NAME ARGUMENTS...: its calls go to $work/calls.
    : >"$work/calls"
    PATH=$work/bin:$PATH sh -eu "$work/scripts-$1/$2" "${@:3}"
}
calls() { grep -q -- "$1" "$work/calls" || { cat "$work/calls"; return 1; }; }
makes_user() { script kingyo postinst configure '' && calls '^systemd-sysusers kingyo.conf$'; }
check 'installing makes the user' makes_user
enables() { script kingyo-kiosk postinst configure '' && calls 'deb-systemd-helper enable kingyo.service' && calls '^systemd-tmpfiles --create'; }
check 'installing turns the service on' enables
stays_off() { # An operator who turned it off: was-enabled says no.
    printf '#!/bin/sh\necho "deb-systemd-helper $*" >>"%s/calls"\n[ "$2" != was-enabled ]\n' "$work" >"$work/bin/deb-systemd-helper"
    script kingyo-kiosk postinst configure 0.0.9 && ! calls ' enable ' >"$work/none" && calls update-state
}
check 'an upgrade leaves off what was turned off' stays_off
keeps() { script kingyo-kiosk postrm "$1" && ! grep /var/lib "$work/calls"; }
check 'removing keeps the data' keeps remove
check 'so does a purge' keeps purge
purges() { script kingyo-kiosk postrm purge && calls '^rm -rf /var/cache/kingyo$'; }
check 'which takes what can be made again' purges
asks_nothing() { ! grep -lE '\bread\b|debconf' "$work"/scripts-*/*; }
check 'nothing is asked' asks_nothing
echo "1..$count"
