#!/bin/bash
# format.sh CLANG_FORMAT -- checks that every C file of the repository has the form of .clang-format.
#
# Prints one line for each file that differs. Exits 1 if any file differs, or if CLANG_FORMAT fails.
set -u
formatter=$1
command -v "$formatter" >/dev/null || { echo "format.sh: $formatter is not installed" >&2; exit 1; }
found=$(git ls-files '*.[ch]' | xargs -n 40 "$formatter" --dry-run --ferror-limit=1 -Werror 2>&1)
status=$?
files=$(sed -nE 's/^([^: ]+):[0-9]+:[0-9]+: error: code should be clang-formatted.*/\1/p' <<<"$found" | sort -u)
if [ -n "$files" ]; then
    printf "  differs from .clang-format: %s\n" $files
    echo "  $(wc -l <<<"$files") files differ; make format rewrites them"
    exit 1
fi
[ "$status" -eq 0 ] || { echo "$found" | head -5 >&2; exit 1; }
echo '  ok    the form of .clang-format'
