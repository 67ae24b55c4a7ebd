#!/bin/bash
# install.sh install|uninstall -- installs the files of board/files.txt below $DESTDIR, or removes them.
#
# The variables PREFIX (default /usr/local), BUILD (build) and PACKAGES ("kingyo kingyo-kiosk") select what and where.
# Files of the operator stay unchanged: an existing configuration file and the data folder. Exits with 74 if a file cannot
# be written, or with 2 after wrong usage.
set -u
cd "$(dirname "$0")/.." || exit 74
PREFIX=${PREFIX:-/usr/local} BUILD=${BUILD:-build} DESTDIR=${DESTDIR:-}
PACKAGES=${PACKAGES:-kingyo kingyo-kiosk}
# Refuses a path with characters that sed or the file list would interpret.
[[ $PREFIX =~ ^/[A-Za-z0-9._/+-]*$ ]] || { echo "install: PREFIX=$PREFIX: expected a path without spaces" >&2; exit 2; }

rows() { # KIND FROM TO: prints the rows of the selected packages.
    sed -e '/^#/d' -e "s#@BUILD@#$BUILD#; s#@PREFIX@#${PREFIX%/}#" board/files.txt |
        while read -r package kind from to; do
            [[ " $PACKAGES " == *" $package "* ]] && echo "$kind $from $to"
        done
}

put() { # KIND FROM TO
    local to=$DESTDIR$3
    case $1 in
    program) install -D -m 755 "$2" "$to" ;;
    # install(1) removes an existing file and creates a new one. It therefore never writes through a link.
    text) sed "s#@PREFIX@#${PREFIX%/}#g" "$2" | install -D -m 644 /dev/stdin "$to" ;;
    conf) [ -e "$to" ] || [ -L "$to" ] || install -D -m 644 "$2" "$to" ;;
    *) echo "install: board/files.txt: unknown kind '$1'" >&2; return 1 ;;
    esac
}

# Removes a file. A folder that only the kiosk uses is removed when it is empty; shared folders stay.
take() { # KIND FROM TO
    local to=$DESTDIR$3
    # A configuration path that is not a regular file belongs to the operator. cmp would block on a FIFO.
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
