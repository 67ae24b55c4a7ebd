#!/bin/bash
# install.sh install|uninstall -- puts what board/files.txt lists below $DESTDIR, or takes it away again.
#
# PREFIX (/usr/local), BUILD (build), PACKAGES ("kingyo kingyo-kiosk") choose. What an operator wrote is
# left alone: a configuration file that is there stays, and so does the data folder. Exits 74 where it
# cannot write, 2 for wrong usage.
set -u
cd "$(dirname "$0")/.." || exit 74
PREFIX=${PREFIX:-/usr/local} BUILD=${BUILD:-build} DESTDIR=${DESTDIR:-}
PACKAGES=${PACKAGES:-kingyo kingyo-kiosk}
# A word that sed or the list would read as something else is no path of ours.
[[ $PREFIX =~ ^/[A-Za-z0-9._/+-]*$ ]] || { echo "install: PREFIX=$PREFIX: expected a path without spaces" >&2; exit 2; }

rows() { # KIND FROM TO, of the packages that are wanted.
    sed -e '/^#/d' -e "s#@BUILD@#$BUILD#; s#@PREFIX@#${PREFIX%/}#" board/files.txt |
        while read -r package kind from to; do
            [[ " $PACKAGES " == *" $package "* ]] && echo "$kind $from $to"
        done
}

put() { # KIND FROM TO
    local to=$DESTDIR$3
    case $1 in
    program) install -D -m 755 "$2" "$to" ;;
    # install(1) removes what is there and makes a new file: a link in its place is never written through.
    text) sed "s#@PREFIX@#${PREFIX%/}#g" "$2" | install -D -m 644 /dev/stdin "$to" ;;
    conf) [ -e "$to" ] || [ -L "$to" ] || install -D -m 644 "$2" "$to" ;;
    *) echo "install: board/files.txt: unknown kind '$1'" >&2; return 1 ;;
    esac
}

# A folder of our own goes when it is empty; what is shared with others stays.
take() { # KIND FROM TO
    local to=$DESTDIR$3
    # Anything but a regular file is the operator's; cmp would wait on a FIFO.
    [ "$1" = conf ] && { [ -L "$to" ] || [ ! -f "$to" ] || ! cmp -s "$2" "$to"; } && return 0
    rm -f "$to" || return 1
    [[ $(dirname "$to") == */kingyo ]] && rmdir "$(dirname "$to")" 2>/dev/null
    return 0
}

each() { # DO
    rows | while read -r kind from to; do
        "$1" "$kind" "$from" "$to" || exit 74
    done
}

case ${1:-} in
install) each put ;;
uninstall) each take ;;
*) echo 'usage: board/install.sh install|uninstall' >&2; exit 2 ;;
esac
