# lib.sh -- what the tests of programs and scripts share: kingyoctl, a folder of their own, a line of TAP for each
# check. Sourced, in the repository's root.
# shellcheck shell=bash disable=SC2034  # Its users use them.
set -u
build=${BUILD:-build}
ctl=$build/kingyoctl
work=$(mktemp -d)
# No test depends on what the user's own stall has stored.
export XDG_DATA_HOME=$work/share
trap 'rm -rf "$work"' EXIT
count=0

check() { # TITLE COMMAND...
    local title=$1
    shift
    count=$((count + 1))
    if "$@" >"$work/said" 2>&1; then echo "ok $count - $title"; else
        echo "not ok $count - $title"
        sed 's/^/# /' "$work/said"
    fi
}

# Prints the line of a check that has been made: STATUS is its exit status.
ok() { # STATUS TITLE
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then echo "ok $count - $2"; else echo "not ok $count - $2"; fi
}

skip() { # TITLE WHY
    count=$((count + 1))
    echo "ok $count - $1 # skip $2"
}
