#!/bin/bash
# test_architecture.sh -- architecture.py draws a small tree that this script writes, and detects
# changes.
# If Graphviz is missing, every test is skipped. Speaks TAP.
set -u
draw=$(realpath "$(dirname "$0")/../../board/docs/architecture.py")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
count=0

if ! command -v dot >/dev/null; then
    echo 'ok 1 # SKIP dot is not installed (board/setup.sh dev installs it)'
    echo '1..1'
    exit 0
fi

check() { # STATUS TITLE
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then echo "ok $count - $2"; else
        echo "not ok $count - $2"
        sed 's/^/# /' "$tree/log"
    fi
}

# The contract core/input.h is below the tank, and core/core.c is above both.
cd "$tree" || exit 1
mkdir -p core/tank/collision drivers build/core/tank build/drivers
echo '' >core/input.h
echo '#include "core/input.h"' >core/tank/tank.h
echo '#include "core/tank/tank.h"' >core/tank/collision/grid.c
printf '#include "core/tank/tank.h"\n#include "core/input.h"\n' >core/core.c
echo '#include "core/input.h"' >drivers/hid.c
echo 'build/core/core.o: core/core.c core/tank/tank.h core/input.h' >build/core/core.d
echo 'build/core/tank/grid.o: core/tank/collision/grid.c core/tank/tank.h \
 core/input.h' >build/core/tank/grid.d
echo 'build/drivers/hid.o: drivers/hid.c core/input.h' >build/drivers/hid.d

"$draw" build picture.svg >log 2>&1 && grep -q '<svg' picture.svg
check $? 'a tree that was built becomes a picture'
grep -q '"core/tank" .label="tank  2.ncollision"' picture.svg
check $? 'a box counts the files of a folder and names its subfolders'
grep -q '"core/tank" -> "core/contracts"' picture.svg
check $? 'an include becomes an arrow'
! grep -q '"core/./" .* "core/contracts"' picture.svg
check $? 'an arrow that other arrows imply is omitted'
! grep -q 'cc3333' picture.svg
check $? 'a tree without a cycle has no red arrow'
"$draw" --check build picture.svg >log 2>&1
check $? 'the picture of an unchanged tree is up to date'

echo '#include "drivers/hid.h"' >>core/tank/tank.h
echo '#include "core/tank/tank.h"' >drivers/hid.h
sed -i 's|core/input.h|core/input.h drivers/hid.h|' build/core/core.d
"$draw" --check build picture.svg >log 2>&1
[ $? -eq 1 ] && grep -q 'make architecture' log
check $? 'a new include makes the picture out of date, and the message names the command'
"$draw" build picture.svg >log 2>&1 && grep -q 'cc3333' picture.svg
check $? 'folders that include each other have red arrows'
"$draw" empty picture.svg >log 2>&1
[ $? -eq 2 ] && grep -q 'run .make. first' log
check $? 'a tree that is not built gives exit status 2'
echo "1..$count"
