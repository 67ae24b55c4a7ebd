# lib.sh -- shared functions of the scripts in this folder: the supported guests and their Debian
# releases.
# Source this file. It needs GUEST and BUILD. All fetched and built files are kept in $cache.
# shellcheck shell=bash disable=SC2034  # the sourcing scripts use these variables
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(cd "$here/../.." && pwd)
BUILD=${BUILD:-build}

# suite is the Debian release, arch the architecture of the guest, linux the version of the source
# package, and cross the prefix of the compiler.
case $GUEST in
    bookworm) suite=bookworm arch=amd64 linux=6.1 machine=x86_64 gpiod=libgpiod2 ;;
    trixie) suite=trixie arch=amd64 linux=6.12 machine=x86_64 gpiod=libgpiod3 ;;
    arm64) suite=bookworm arch=arm64 linux=6.1 machine=aarch64 gpiod=libgpiod2 ;;
    card) suite=trixie arch=arm64 linux=6.12 machine=aarch64 gpiod=libgpiod3 ;; # tests/vm/board: the card of make image BOARD=rpi4
    *)
        echo "test-vm: GUEST is bookworm, trixie or arm64, not '$GUEST'" >&2
        exit 2
        ;;
esac
tuple=$machine-linux-gnu cross=
[ "$arch" = amd64 ] || cross=$tuple-
mkdir -p "$BUILD/vm/$GUEST"
cache=$(cd "$BUILD/vm/$GUEST" && pwd)
days_max=7 # Maximum age of fetched files in days. A mirror removes old kernels after that time.

step() { printf '[%4d s] %s\n' "$SECONDS" "$*"; }

# Returns 0 if FILE was made less than days_max days ago.
is_fresh() { [ -n "$(find "$1" -maxdepth 0 -mtime "-$days_max" 2>/dev/null)" ]; }

# Runs apt for the guest's release and architecture, separately from this machine's own apt.
guest_apt() { # COMMAND...
    local dir=$cache/apt
    if ! is_fresh "$dir/updated"; then
        mkdir -p "$dir"/{lists,archives}/partial
        "$top/board/debian_sources.sh" "$suite" test-vm >"$dir/sources.list"
        : >"$dir/status"
        cat >"$dir/apt.conf" <<END
Dir::State "$dir"; Dir::State::lists "$dir/lists"; Dir::State::status "$dir/status";
Dir::Cache "$dir"; Dir::Etc::sourcelist "$dir/sources.list"; Dir::Etc::sourceparts "-";
APT::Architecture "$arch"; APT::Architectures { "$arch"; $([ "$arch" = amd64 ] || echo '"amd64";') }; APT::Sandbox::User "root";
END
        APT_CONFIG=$dir/apt.conf apt-get -qq update
        touch "$dir/updated"
    fi
    APT_CONFIG=$dir/apt.conf "$@"
}

# Prints the current kernel of the release, such as "6.1.0-56-amd64".
kernel_release() {
    guest_apt apt-cache depends "linux-image-$arch" | sed -n 's/.*Depends: linux-image-//p' | head -1
}

# Unpacks packages into a folder without configuring them. The programs in the folder can run, and
# unpacking takes seconds.
unpack_root() { # FOLDER ARCHITECTURES PACKAGES, the last two separated by commas
    local -a lines
    rm -rf --one-file-system "$1"
    mapfile -t lines < <("$top/board/debian_sources.sh" "$suite" test-vm)
    mmdebstrap --quiet --mode=root --variant=extract --architectures="$2" --include="$3" \
        "$suite" "$1" "${lines[@]}" 2>"$1.log" || {
        tail -5 "$1.log" >&2
        return 1
    }
}

# Does the part of the maintainer scripts' work that programs in the folder need.
settle_root() { # FOLDER
    local part
    for part in bin sbin lib lib64; do
        if [ -d "$1/$part" ] && [ ! -L "$1/$part" ]; then
            mkdir -p "$1/usr/$part"
            cp -a "$1/$part/." "$1/usr/$part/"
            rm -rf "${1:?}/$part"
            ln -s "usr/$part" "$1/$part"
        fi
    done
    mkdir -p "$1"/{dev,proc,sys,run,tmp,root,host,etc}
    [ -e "$1/usr/bin/awk" ] || ln -s mawk "$1/usr/bin/awk"
    [ -e "$1/etc/passwd" ] || echo 'root:x:0:0:root:/root:/bin/sh' >"$1/etc/passwd"
    [ -e "$1/etc/group" ] || printf '%s\n' root:x:0: tty:x:5: disk:x:6: kmem:x:15: video:x:44: \
        render:x:105: input:x:106: dialout:x:20: audio:x:29: lp:x:7: cdrom:x:24: tape:x:26: \
        sgx:x:107: kvm:x:108: plugdev:x:46: kingyo:x:990: >"$1/etc/group"
}

# Copies modules and their dependencies from a kernel's files to another root, and lists them
# there.
copy_modules() { # FROM RELEASE TO MODULES
    local module file to
    for module in $4; do
        modprobe -d "$1" -S "$2" --show-depends "$module" 2>/dev/null || true
    done | awk '$1 == "insmod" { print $2 }' | sort -u | while read -r file; do
        to=$3/${file#"$1"/}
        mkdir -p "${to%/*}"
        case $file in # Unpacked here, because the modprobe of busybox does not support xz.
            *.xz) xz -dc "$file" >"${to%.xz}" ;;
            *) cp "$file" "$to" ;;
        esac
    done
    depmod -b "$3" "$2"
}
