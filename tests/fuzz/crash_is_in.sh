#!/bin/bash
# crash_is_in.sh LIBRARY LOG -- returns 0 if the crash in a fuzzer's log occurred inside LIBRARY.
# The top of the stack may belong to libc (strncmp in a library's loop). The first frame that
# belongs to the library or has a source line is therefore decisive, because only our code has
# source lines. If our code misuses data of the library, our frame is above the library's.
set -u
awk -v library="$1" '
    /ERROR: (AddressSanitizer|libFuzzer)|runtime error:/ { is_report = 1 }
    is_report && /^ *#[0-9]+ / {
        if (index($0, library)) { found = 1; exit }
        if ($0 ~ /\.[ch]:[0-9]+/) { exit }
    }
    END { exit !found }' "$2"
