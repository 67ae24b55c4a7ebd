# lib.sh -- what the tests of kingyoctl's commands share: the program, a folder of their own, a line of TAP
# for each check. Sourced.
# shellcheck shell=bash disable=SC2034  # Its users use them.
set -u
build=${BUILD:-build}
ctl=$build/kingyoctl
work=$(mktemp -d)
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
