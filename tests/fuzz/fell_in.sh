#!/bin/bash
# fell_in.sh LIBRARY LOG -- whether what a fuzzer's log tells of happened inside LIBRARY: exit 0 if so.
#
# The top of the stack may be libc's (strncmp in a library's loop), so the first frame counts that is
# either the library's or has a source line, which only ours have. What we do wrongly with what it
# gave us has our frame on top.
set -u
awk -v library="$1" '
    /ERROR: (AddressSanitizer|libFuzzer)|runtime error:/ { told = 1 }
    told && /^ *#[0-9]+ / {
        if (index($0, library)) { found = 1; exit }
        if ($0 ~ /\.[ch]:[0-9]+/) { exit }
    }
    END { exit !found }' "$2"
