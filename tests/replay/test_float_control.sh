#!/bin/bash
# test_float_control.sh -- a library that leaves flush-to-zero enabled changes no result of the
# programs. If the mode of a thread cannot be kept, the program reports an error instead of a wrong
# hash. Clang compiles the code that sets the control word of each architecture. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"

sets() { # TARGET INSTRUCTION: The code that Clang compiles for TARGET contains INSTRUCTION.
    clang --target="$1" -ffreestanding -std=c17 -O2 -Wall -Wextra -Werror -I. -S -o "$work/cpu.s" platform/cpu.c &&
        clang --target="$1" -ffreestanding -std=c17 -O2 -ffp-contract=off -Wall -Wextra -Werror -I. -c \
            -o "$work/float_env.o" core/base/float_env.c && grep -iq "$2" "$work/cpu.s"
}
check 'the code for AArch64 sets FPCR' sets aarch64-linux-gnu 'msr[[:space:]]*fpcr'
check 'the code for 32-bit Arm sets FPSCR' sets armv7-linux-gnueabihf 'vmsr[[:space:]]*fpscr'
check 'the code for RISC-V sets fcsr' sets riscv64-linux-gnu 'fscsr'
check 'the code for x86-64 sets MXCSR' sets x86_64-linux-gnu 'ldmxcsr'

if [ "$(uname -m)" != x86_64 ]; then
    skip 'programs with a library that enables flush-to-zero' 'the library is written for x86-64'
    echo "1..$count"
    exit
fi
gcc -shared -fPIC -O1 -o "$work/mode.so" tests/replay/float_mode.c -ldl
# In a build with sanitizers, their runtime library must be loaded first.
with_mode() { LD_PRELOAD="$work/mode.so" "$@"; }
play() { "$ctl" play --bot expert --seed 5 --round-s 10 --rounds 2 --jobs 2 --json; }
play >"$work/clean.json"
with_mode play >"$work/mode.json"
check 'kingyoctl play gives the same states with flush-to-zero enabled' cmp "$work/clean.json" "$work/mode.json"
tank() { "$ctl" tank --fish 30 --seconds 3 --seed 2 --json | grep -o '"state_hash": "[0-9a-f]*"'; }
tank >"$work/clean"
with_mode tank >"$work/mode"
check 'kingyoctl tank prints a hash' test -s "$work/clean"
check 'kingyoctl tank gives the same hash with flush-to-zero enabled' cmp "$work/clean" "$work/mode"

"$ctl" play --bot expert --seed 5 --round-s 10 --record "$work/rec" >"$work/output"
round=$work/rec/round-00001.kgr
check 'a recording verifies with flush-to-zero enabled' with_mode "$ctl" replay verify "$round"
refused() {
    FLOAT_MODE_IN=pread with_mode "$ctl" replay verify "$round" >"$work/out" 2>"$work/err"
    local code=$?
    cat "$work/out" "$work/err"
    [ $code = 1 ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" = 1 ] &&
        grep -q '^kingyoctl replay: this machine.s floating point' "$work/err"
}
check 'a mode that each read changes gives one line and exit 1' refused
echo "1..$count"
