#!/bin/bash
# tidy.sh CLANG_TIDY FILE... -- checks the C files with clang-tidy and the checks of .clang-tidy.
#
# Without FILE, the script checks every production source that compile_commands.json lists. With PART=k/n in the
# environment, it checks only every n-th of these, beginning with the k-th (1 .. n), and those that changed since the
# commit n before this one, so that n commits in a row check all. Prints the findings. Exits 1 after a finding, or if
# CLANG_TIDY fails, and 2 if PART has another form.
set -u
tidy=$1
shift
command -v "$tidy" >/dev/null || { echo "tidy.sh: $tidy is not installed" >&2; exit 1; }
if [ $# -eq 0 ]; then
    mapfile -t listed < <(grep -oP '"file": "\K(core|drivers|platform|board|assets)/[^"]+\.c' compile_commands.json | sort)
    if [ -n "${PART:-}" ]; then
        [[ $PART =~ ^([1-9][0-9]*)/([1-9][0-9]*)$ ]] && [ "${BASH_REMATCH[1]}" -le "${BASH_REMATCH[2]}" ] ||
            { echo "tidy.sh: PART=$PART is not k/n with k from 1 to n" >&2; exit 2; }
        part=${BASH_REMATCH[1]} parts=${BASH_REMATCH[2]}
        mapfile -t listed < <({ printf '%s\n' "${listed[@]}" | awk -v k="$part" -v n="$parts" 'NR % n == k % n'
            git diff --name-only --diff-filter=d "HEAD~$parts" 2>/dev/null | grep -xF -f <(printf '%s\n' "${listed[@]}"); } | sort -u)
    fi
    set -- "${listed[@]}"
fi
found=$(printf '%s\n' "$@" | xargs -P "$(nproc)" -n 4 "$tidy" --quiet -p . 2>/dev/null)
status=$?
if [ "$status" -ne 0 ]; then
    echo "${found:-tidy.sh: $tidy failed without a finding}"
    exit 1
fi
echo "  ok    clang-tidy: no finding in $# files"
