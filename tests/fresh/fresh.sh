#!/bin/bash
# fresh.sh [RELEASE...] -- checks that `make run` and `make test` need only Debian and make.
# For each release (default bookworm and trixie) the script makes the smallest root file system
# that supports apt, copies the tree into it and runs both commands inside, without a screen, in
# either order. Both commands then run again, to check that the second time is fast, and once more
# after libassimp-dev was removed, which make test installs again. The screens of both releases are
# compared with the golden pictures (make ui-gallery). The empty root is kept as
# BUILD/fresh/RELEASE.tar and reused for a week. The script prints a table at the end. It needs
# root, mmdebstrap and the mirror of this machine's apt. FRESH_DIR is the folder for the roots and
# the logs, which are kept there (two to three GiB each). Without FRESH_DIR they are written to
# /var/tmp and removed.
set -u
releases=("$@")
[ ${#releases[@]} -gt 0 ] || releases=(bookworm trixie)
if [ "$(id -u)" -ne 0 ]; then
    echo 'test-fresh: making a root file system needs root; please run: sudo make test-fresh' >&2
    exit 1
fi
top=${FRESH_DIR:-$(mktemp -d /var/tmp/kingyo-fresh-XXXXXX)}
mkdir -p "$top"
cache=${BUILD:-build}/fresh
mkdir -p "$cache"
failed=0 rows=()

board/debian_sources.sh bookworm test-fresh >/dev/null || exit 1

unmount() {
    local part
    for part in dev/shm dev/pts dev proc; do
        mountpoint -q "$top/$1/$part" && umount "$top/$1/$part"
    done
}
finish() {
    for release in "${releases[@]}"; do
        unmount "$release"
    done
    [ -n "${FRESH_DIR:-}" ] || rm -rf --one-file-system "$top"
}
trap finish EXIT

# Runs COMMAND, keeps its output and adds a row to the table. The row quotes the last useful line
# of the output.
step() { # RELEASE WHAT COMMAND...
    local release=$1 what=$2 begin=$SECONDS log status
    log="$top/$release-${what// /-}.log"
    shift 2
    printf '== %s: %s (%s)\n' "$release" "$what" "$(date +%H:%M:%S)"
    "$@" >"$log" 2>&1 </dev/null
    status=$?
    rows+=("$(printf '%-10s %-22s %5d s  %-6s %s' "$release" "$what" $((SECONDS - begin)) \
        "$([ $status -eq 0 ] && echo ok || echo FAILED)" "$(quote "$log")")")
    printf '   %s after %d s %s\n' "$([ $status -eq 0 ] && echo ok || echo "FAILED ($status)")" $((SECONDS - begin)) \
        "$(quote "$log")"
    if [ $status -ne 0 ]; then
        failed=1
        tail -30 "$log" | sed 's/^/    /'
    fi
    return $status
}
quote() { grep -E ' passed, [0-9]+ failed$|fish caught|differ; largest' "$1" | tail -1 | tr -s ' '; }

# Makes the empty root from the cache or from the mirror. The file is written under another name
# first, so that an interrupted file is never used.
base() { # RELEASE
    local tar=$cache/$1.tar sources
    [ -n "$(find "$tar" -mtime -7 2>/dev/null)" ] && return
    mapfile -t sources < <(board/debian_sources.sh "$1" test-fresh)
    rm -f "$tar.new"
    mmdebstrap --mode=root --variant=minbase --include=make --format=tar "$1" "$tar.new" "${sources[@]}" &&
        mv "$tar.new" "$tar"
}

make_root() { # RELEASE
    local root=$top/$1
    unmount "$1"
    rm -rf --one-file-system "$root"
    base "$1" && mkdir -p "$root" && tar xf "$cache/$1.tar" -C "$root" --exclude='./dev/*' || return 1
    rm -rf "$root"/var/lib/apt/lists/* # A downloaded image has no package lists either.
    cp /etc/resolv.conf "$root/etc/" 2>/dev/null
    mkdir -p "$root/kingyo" "$root/proc" "$root/dev"
    git ls-files -co --exclude-standard -z | tar cf - --null -T - | tar xf - -C "$root/kingyo"
    mount --bind /dev "$root/dev" && mount -t proc proc "$root/proc" &&
        mount --bind /dev/pts "$root/dev/pts"
}

inside() { # RELEASE COMMAND...
    local release=$1
    shift
    env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root TERM=dumb \
        ${http_proxy:+http_proxy="$http_proxy"} chroot "$top/$release" sh -c "cd /kingyo && $*"
}

# Runs both commands in both orders, each in a new root; then removes a package and installs it
# again in the built tree. Every `make test` sets up, builds and links everything. The first run
# after `make run` executes all tests. The other runs execute only the tests of `import`, whose
# results depend on the removed package (assimp).
for release in "${releases[@]}"; do
    step "$release" 'minimal root' make_root "$release" || continue
    step "$release" 'make test first' inside "$release" make test ONLY=import
    step "$release" 'make run after it' inside "$release" make run
    step "$release" 'minimal root again' make_root "$release" || continue
    step "$release" 'make run' inside "$release" make run
    step "$release" 'make run again' inside "$release" make run
    step "$release" 'make test' inside "$release" make test
    step "$release" 'make ui-gallery' inside "$release" make ui-gallery
    step "$release" 'make test again' inside "$release" make test ONLY=import
    step "$release" 'a package removed' inside "$release" apt-get -qq remove -y libassimp-dev
    step "$release" 'make run without it' inside "$release" make run
    step "$release" 'make test adds it' inside "$release" make test ONLY=import
    step "$release" 'make run with it' inside "$release" make run
    unmount "$release"
done
echo
printf '%s\n' "${rows[@]}"
exit $failed
