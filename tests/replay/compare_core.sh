#!/bin/bash
# compare_core.sh -- the core that `make unit` compiled plays half a minute, and gives the golden hashes in each second.
# `make unit ARCH=arm64` thereby compares the core of another processor. Speaks TAP. If a hash differs, the output gives the
# first second.
set -u
program=${BUILD:-build}/tests/replay/state_hash golden=tests/replay/golden.txt
out=$(mktemp)
trap 'rm -f "$out"' EXIT
if "$program" >"$out" && cmp -s "$out" "$golden"; then
    echo "ok 1 - $(wc -l <"$golden") seconds of play on $(uname -m) give the golden hashes"
else
    echo "not ok 1 - half a minute of play on $(uname -m) gives the golden hashes"
    diff "$golden" "$out" | head -3 | sed 's/^/# /'
fi
echo 1..1
