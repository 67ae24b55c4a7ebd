#!/bin/bash
# test_deb.sh -- the Debian packages: their content, identical bytes after a second build, the
# actions of their scripts. Speaks TAP.
# The scripts call replacement commands here that only record their calls; tests/fresh/deb.sh
# installs, upgrades, removes and purges the packages in a Debian root.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
cd "$(dirname "$0")/../.." || exit 1
build=$(realpath "$build")
if ! command -v dpkg-shlibdeps >/dev/null; then
    echo '1..0 # skip no dpkg-shlibdeps (package dpkg-dev)'
    exit 0
fi
# A separate build folder, which uses only the programs of the real one.
mkdir "$work/build"
ln -s "$build/kingyo" "$build/kingyoctl" "$work/build/"
[ -d "$build/man" ] && ln -s "$build/man" "$work/build/"
export LEVEL=1 # The compression level does not matter, because both builds use the same level.
make_debs() { BUILD=$work/build board/deb/deb.sh >"$work/names"; }
check 'the build makes two packages' make_debs
check 'the packages have names' grep -c . "$work/names"
for package in kingyo kingyo-kiosk; do
    mkdir -p "$work/$package" "$work/scripts-$package"
    file=$(ls "$work/build/deb/${package}"_*.deb)
    dpkg-deb -x "$file" "$work/$package"
    dpkg-deb -e "$file" "$work/scripts-$package"
done

# ---- Content
all_rows() { # Each row's file is in its package, and in no other.
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
check 'every file of the package belongs to root' of_root "$work"/build/deb/kingyo_*.deb
sums() { (cd "$work/$1" && md5sum --quiet -c "$work/scripts-$1/md5sums") && ! grep -E '  /|DEBIAN' "$work/scripts-$1/md5sums"; }
check 'the checksums of kingyo match its files' sums kingyo
check 'the checksums of kingyo-kiosk match its files' sums kingyo-kiosk
depends() { dpkg-deb -f "$work"/build/deb/kingyo_*.deb Depends | grep libc6 | grep libsdl2-2.0-0 | grep libsqlite3-0 | grep libusb-1.0-0; }
check 'the package depends on every linked library' depends
same_version() { [ "$(dpkg-deb -f "$1" Version)" = "$("$build/kingyo" --version | cut -d' ' -f2)" ]; }
check 'the version of the package is that of the program' same_version "$work"/build/deb/kingyo_*.deb
newest_change() { # The parser of dpkg reads the changelog that was made from CHANGELOG.md.
    zcat "$work/kingyo/usr/share/doc/kingyo/changelog.gz" >"$work/changelog" &&
        [ "$(dpkg-parsechangelog -l "$work/changelog" -S Version)" = "$("$build/kingyo" --version | cut -d' ' -f2)" ] &&
        dpkg-parsechangelog -l "$work/changelog" -S Changes | grep '^  \*' >/dev/null
}
if command -v dpkg-parsechangelog >/dev/null; then
    check 'the newest entry of the changelog has this version' newest_change
else
    skip 'the newest entry of the changelog has this version' 'no dpkg-parsechangelog'
fi
conffile() { grep -qx /etc/kingyo/kingyo.conf "$work/scripts-kingyo/conffiles"; }
check "the configuration is a conffile, so dpkg keeps the operator's changes" conffile
no_takings() { ! find "$work/kingyo" "$work/kingyo-kiosk" -path '*/var/*' | grep .; }
check 'no package owns the data folder' no_takings
again() { # The second build has clocks that are an hour later, another umask and another folder.
    cp -r "$work/build/deb" "$work/first" && find "$work/build" -name '*.deb' -delete || return 1
    mkdir "$work/elsewhere" && cp -P "$work/build/kingyo" "$work/build/kingyoctl" "$work/elsewhere/" || return 1
    [ -e "$work/build/man" ] && cp -P "$work/build/man" "$work/elsewhere/"
    (umask 077 && TZ=Asia/Tokyo LC_ALL=C BUILD=$work/elsewhere board/deb/deb.sh) || return 1
    for file in "$work"/first/*.deb; do
        cmp "$file" "$work/elsewhere/deb/$(basename "$file")" || return 1
    done
}
check 'a second build gives identical packages' again
if command -v lintian >/dev/null; then
    lintian_accepts() { lintian --allow-root --fail-on error,warning "$work"/first/*.deb; }
    check 'lintian reports no error and no warning' lintian_accepts
else
    skip 'lintian reports no error and no warning' 'no lintian'
fi

# ---- Maintainer scripts
mkdir "$work/bin"
for command in systemd-sysusers systemd-tmpfiles udevadm systemctl deb-systemd-helper deb-systemd-invoke rm; do
    printf '#!/bin/sh\necho "%s $*" >>"%s/calls"\n' $command "$work" >"$work/bin/$command"
done
chmod +x "$work/bin"/*
script() { # PACKAGE NAME ARGUMENTS...: The script's calls are written to $work/calls.
    : >"$work/calls"
    PATH=$work/bin:$PATH sh -eu "$work/scripts-$1/$2" "${@:3}"
}
calls() { grep -q -- "$1" "$work/calls" || { cat "$work/calls"; return 1; }; }
makes_user() { script kingyo postinst configure '' && calls '^systemd-sysusers kingyo.conf$'; }
check 'the installation creates the user' makes_user
enables() { script kingyo-kiosk postinst configure '' && calls 'deb-systemd-helper enable kingyo.service' && calls '^systemd-tmpfiles --create'; }
check 'the installation enables the service' enables
stays_off() { # The operator disabled the service, so was-enabled fails.
    printf '#!/bin/sh\necho "deb-systemd-helper $*" >>"%s/calls"\n[ "$2" != was-enabled ]\n' "$work" >"$work/bin/deb-systemd-helper"
    script kingyo-kiosk postinst configure 0.0.9 && ! calls ' enable ' >"$work/none" && calls update-state
}
check 'an upgrade keeps a disabled service disabled' stays_off
keeps() { script kingyo-kiosk postrm "$1" && ! grep /var/lib "$work/calls"; }
check 'the removal keeps the data' keeps remove
check 'a purge keeps the data' keeps purge
purges() { script kingyo-kiosk postrm purge && calls '^rm -rf /var/cache/kingyo$'; }
check 'a purge removes the cache' purges
asks_nothing() { ! grep -lE '\bread\b|debconf' "$work"/scripts-*/*; }
check 'the scripts ask no question' asks_nothing
echo "1..$count"
