#!/bin/bash
# deb.sh -- makes the Debian packages of the files in board/files.txt, in $BUILD/deb/, and prints their names.
#
# Uses only dpkg-deb. The same tree and the same SOURCE_DATE_EPOCH (default: the time of the newest commit) give the same
# bytes on every machine. LEVEL=1 packs faster. VERSION= replaces the program's version, to test upgrades. DEB_HOST_ARCH=
# and STRIP= name the processor of the programs and its strip(1), if they are for another machine. Needs dpkg-dev, but not
# root. Exits with 74 if a file cannot be made.
set -eu
cd "$(dirname "$0")/../.."
BUILD=${BUILD:-build}
out=$BUILD/deb
version=${VERSION:-$(sed -nE 's/^#define KINGYO_VERSION "([0-9][0-9A-Za-z.~+]*)".*/\1/p' core/core.h)}
architecture=${DEB_HOST_ARCH:-$(dpkg --print-architecture)}
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || stat -c %Y core/core.h)}
export SOURCE_DATE_EPOCH
[ -n "$version" ] || { echo 'deb: core/core.h names no version' >&2; exit 74; }
umask 022
rm -rf "$out"
mkdir -p "$out"
trap 'rm -rf "$out"/root-* "$out/debian"' EXIT

# Prints the packages that contain the libraries of the programs.
libraries() { # ROOT
    mkdir -p "$out/debian"
    printf 'Source: kingyo\n\nPackage: kingyo\nArchitecture: any\n' >"$out/debian/control"
    (cd "$out" && dpkg-shlibdeps -O root-kingyo/usr/bin/kingyo root-kingyo/usr/bin/kingyoctl 2>shlibdeps.log) |
        sed -n 's/^shlibs:Depends=//p'
}

# Prints CHANGELOG.md in Debian's format. A version that CHANGELOG.md does not list yet comes first.
changelog() {
    VERSION=$version DATE=$(date -u -d "@$SOURCE_DATE_EPOCH" +%F) LC_ALL=C awk '
        function rfc_2822(on,   command, line) {
            command = "date -u -R -d " on
            command | getline line
            close(command)
            return line
        }
        function end_version() {
            if (is_open) printf "\n -- The Kingyo authors <kingyo@example.org>  %s\n\n", rfc_2822(date)
        }
        function begin_version(version, on) {
            end_version()
            date = on
            is_open = 1
            printf "kingyo (%s) unstable; urgency=medium\n\n", version
        }
        function print_wrapped(first, rest, text,   count, i, line, word) {
            count = split(text, word, " ")
            line = first
            for (i = 1; i <= count; i++) {
                if (length(line) + length(word[i]) > 78) { print line; line = rest }
                line = line " " word[i]
            }
            print line
        }
        $1 == "##" {
            if (!is_open && $2 != ENVIRON["VERSION"]) {
                begin_version(ENVIRON["VERSION"], ENVIRON["DATE"])
                print "  * See the commits since the version below."
            }
            begin_version($2, $4)
            next
        }
        is_open && /^- / { print_wrapped("  *", "   ", substr($0, 3)) }
        END { end_version() }' CHANGELOG.md
}

documents() { # PACKAGE ROOT
    local folder=$2/usr/share/doc/$1
    mkdir -p "$folder"
    install -m 644 board/deb/copyright "$folder/copyright"
    changelog | gzip -9n >"$folder/changelog.gz"
    if [ -d "$2/usr/share/man" ]; then
        find "$2/usr/share/man" -type f -exec gzip -9n {} +
    fi
}

control() { # PACKAGE ROOT: writes the package's DEBIAN folder.
    local size script to
    mkdir -p "$2/DEBIAN"
    # Size in KiB as Debian counts it: the size of each file is rounded up, and each folder counts as one KiB.
    size=$(find "$2" -path "$2/DEBIAN" -prune -o -printf '%y %s\n' |
        awk '{ sum += $1 == "f" ? int(($2 + 1023) / 1024) : 1 } END { print sum }')
    sed -e "s/@VERSION@/$version/; s/@ARCHITECTURE@/$architecture/; s/@SIZE@/$size/" \
        -e "s/@LIBRARIES@/$([ "$1" = kingyo ] && libraries "$2")/" "board/deb/$1.control" >"$2/DEBIAN/control"
    (cd "$2" && find . -path ./DEBIAN -prune -o -type f -printf '%P\n' | LC_ALL=C sort | xargs md5sum) \
        >"$2/DEBIAN/md5sums"
    (cd "$2" && find etc -type f 2>/dev/null | LC_ALL=C sort | sed 's#^#/#') >"$2/DEBIAN/conffiles"
    [ -s "$2/DEBIAN/conffiles" ] || rm "$2/DEBIAN/conffiles"
    for script in postinst prerm postrm; do
        to=$2/DEBIAN/$script
        [ -e "board/deb/$1.$script" ] && install -m 755 "board/deb/$1.$script" "$to"
    done
    return 0
}

for package in kingyo kingyo-kiosk; do
    root=$out/root-$package
    PACKAGES=$package DESTDIR=$root PREFIX=/usr BUILD=$BUILD board/install.sh install
    if [ -d "$root/usr/bin" ]; then
        "${STRIP:-strip}" --strip-unneeded --remove-section=.comment --remove-section=.note "$root"/usr/bin/*
    fi
    documents $package "$root"
    control $package "$root"
    file=$out/${package}_${version}_$(sed -n 's/^Architecture: //p' "$root/DEBIAN/control").deb
    find "$root" -exec touch -h -d "@$SOURCE_DATE_EPOCH" {} +
    dpkg-deb --root-owner-group -Zxz "-z${LEVEL:-6}" --build "$root" "$file" >"$out/build.log"
    echo "$file"
done
