#!/bin/bash
# tidy.sh CLANG_TIDY FILE... -- checks the C files with clang-tidy and the checks of .clang-tidy.
#
# Without FILE, the script checks every production source that compile_commands.json lists. Prints the findings. Exits 1
# after a finding, or if CLANG_TIDY fails.
set -u
tidy=$1
shift
command -v "$tidy" >/dev/null || { echo "tidy.sh: $tidy is not installed" >&2; exit 1; }
if [ $# -eq 0 ]; then
    mapfile -t listed < <(grep -oP '"file": "\K(core|drivers|platform|board|assets)/[^"]+\.c' compile_commands.json | sort)
    set -- "${listed[@]}"
fi
found=$(printf '%s\n' "$@" | xargs -P "$(nproc)" -n 4 "$tidy" --quiet -p . 2>/dev/null)
status=$?
if [ "$status" -ne 0 ]; then
    echo "${found:-tidy.sh: $tidy failed without a finding}"
    exit 1
fi
echo "  ok    clang-tidy: no finding in $# files"
