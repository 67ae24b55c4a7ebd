# lib.sh -- shared functions for tests of programs and scripts. They set the path of kingyoctl,
# create a temporary folder and print one TAP line for each check. $failed is 1 after a failed
# check. Source this file in the root of the repository.
# shellcheck shell=bash disable=SC2034  # The scripts that source this file use the variables.
set -u
build=${BUILD:-build}
ctl=$build/kingyoctl
work=$(mktemp -d)
# XDG_DATA_HOME is set so that no test depends on the data of the user's own kiosk.
export XDG_DATA_HOME=$work/share
trap 'rm -rf "$work"' EXIT
count=0 failed=0

check() { # TITLE COMMAND...
    local title=$1
    shift
    count=$((count + 1))
    if "$@" >"$work/check.log" 2>&1; then echo "ok $count - $title"; else
        echo "not ok $count - $title"
        sed 's/^/# /' "$work/check.log"
        failed=1
    fi
}

# Prints the TAP line of a check that has already run. STATUS is the exit status of the check.
ok() { # STATUS TITLE
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then echo "ok $count - $2"; else echo "not ok $count - $2" && failed=1; fi
}

skip() { # TITLE WHY
    count=$((count + 1))
    echo "ok $count - $1 # skip $2"
}
