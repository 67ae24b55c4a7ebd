# inside.sh -- sourced by build.sh and bench.sh after they set `root`, the root file system: runs a command in it.
# shellcheck shell=bash
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# Runs a command inside the root, with the tree of this project at /kingyo.
inside() {
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 \
        unshare --mount --fork sh -c 'root=$1; source=$2; shift 2
            mkdir -p "$root/kingyo" && mount --bind "$source" "$root/kingyo" &&
            mount -t proc proc "$root/proc" && mount --rbind /dev "$root/dev" && exec chroot "$root" "$@"' \
        inside "${root:?}" "$source" "$@"
}
