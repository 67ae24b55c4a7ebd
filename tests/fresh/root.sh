# root.sh NAME -- a root file system in a temporary folder, and TAP output, for the tests of packages. Source the file.
# $root is the root, and $top is the temporary folder around it. Both are removed when the script ends.
# shellcheck shell=bash disable=SC2034  # the scripts that source this file use the variables
top=$(mktemp -d "/var/tmp/kingyo-${1:?a name}-XXXXXX")
root=$top/root
finish() {
    mountpoint -q "$root/proc" && umount "$root/proc"
    rm -rf --one-file-system "$top"
}
trap finish EXIT
mkdir -p "$root"

unpack_root() { # TAR: Unpacks a root that mmdebstrap has made. systemd-tmpfiles reaches files through /proc.
    tar -C "$root" -xf "$1" --exclude='./dev/*' && mount -t proc proc "$root/proc"
}

count=0 failed=0
check() { # TITLE COMMAND...
    local title=$1
    shift
    count=$((count + 1))
    if "$@" >"$top/output" 2>&1 </dev/null; then echo "ok $count - $title"; else
        echo "not ok $count - $title"
        sed 's/^/# /' "$top/output"
        failed=1
    fi
}
