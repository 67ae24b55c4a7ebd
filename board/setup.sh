#!/bin/bash
# setup.sh PURPOSE... -- installs the packages for these purposes (run, test, dev) if they are missing.
#
# board/packages.txt lists the packages with the reason for each. If no package is missing, the script asks dpkg once and
# ends. Otherwise root, or a user whose sudo needs no password, installs the packages; the script prints which and why.
# Any other user gets the command to run. Exits with 0 if all packages are installed, otherwise with 1. On a system other
# than Debian the script names the list and exits with 0, because only the user can know what is installed there.
set -u
here=$(dirname "$0")

wanted() { # Prints lines `package reason` for the purposes. The purpose test includes run.
    local purposes=" $* "
    case $purposes in *' test '*) purposes+='run ' ;; esac
    awk -v purposes="$purposes" '!/^#/ && NF && index(purposes, " " $2 " ") {
        name = $1; $1 = $2 = ""; sub(/^ +/, ""); print name "\t" $0 }' "$here/packages.txt"
}

missing() { # Prints those lines of standard input whose package is not installed.
    local installed
    # shellcheck disable=SC2046
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $(wanted "$@" | cut -f1) 2>/dev/null |
        sed -n 's/^installed //p')
    wanted "$@" | awk -F'\t' -v installed="$installed" 'BEGIN {
        count = split(installed, names, "\n"); for (i = 1; i <= count; i++) have[names[i]] = 1 }
        !($1 in have)'
}

if ! command -v dpkg-query >/dev/null; then
    echo 'setup: this is not a Debian system; board/packages.txt lists what Kingyo needs' >&2
    exit 0
fi
lines=$(missing "$@")
[ -z "$lines" ] && exit 0
packages=$(cut -f1 <<<"$lines" | tr '\n' ' ')
install="apt-get install -y --no-install-recommends ${packages% }"

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
        as_root=(sudo -n)
    else
        echo 'setup: packages are missing and this user may not install them. Please run:' >&2
        echo "  sudo sh -c 'apt-get update && $install'" >&2
        exit 1
    fi
fi
echo 'Kingyo needs these Debian packages and installs them now:'
awk -F'\t' '{ printf "  %-28s %s\n", $1, $2 }' <<<"$lines"

export DEBIAN_FRONTEND=noninteractive
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() { # Prints apt's output only if apt fails.
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 "$@" >"$log" 2>&1
}
update() {
    echo '  asking the mirror what is new ...'
    apt update || { tail -5 "$log" >&2; echo 'setup: apt-get update failed' >&2; exit 1; }
}
# Retries once with new package lists, because the lists may be missing or too old.
compgen -G '/var/lib/apt/lists/*_Packages*' >/dev/null || { update; fresh=1; }
echo '  installing ...'
# shellcheck disable=SC2086
if ! apt install -y --no-install-recommends $packages; then
    [ "${fresh:-0}" -eq 1 ] || { update; apt install -y --no-install-recommends $packages; } || true
fi
lines=$(missing "$@")
if [ -n "$lines" ]; then
    tail -15 "$log" >&2
    echo "setup: could not install $(cut -f1 <<<"$lines" | tr '\n' ' ')-- run: $install" >&2
    exit 1
fi
echo '  done'
