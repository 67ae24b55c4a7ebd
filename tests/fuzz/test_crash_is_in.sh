#!/bin/bash
# test_crash_is_in.sh -- a crash is attributed to a library only if the library's frame is above all of
# our frames. Speaks TAP.
set -u
cd "$(dirname "$0")/../.." || exit 1
log=$(mktemp)
trap 'rm -f "$log"' EXIT
count=0

expect_status() { # STATUS TEXT, the log on standard input: Test TEXT: crash_is_in.sh returns STATUS for this log.
    count=$((count + 1))
    cat >"$log"
    tests/fuzz/crash_is_in.sh libassimp "$log"
    [ $? -eq "$1" ] && echo "ok $count - $2" || echo "not ok $count - $2"
}

expect_status 0 'a crash in a libc function that the library called is attributed to the library' <<'E2'
==1==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x6
    #0 0x5 in strncmp (build/fuzz/fuzz_scene+0xd8ffc)
    #1 0x7 (/lib/libassimp.so.5+0x7477d2)
    #2 0x5 in import_flatten platform/ctl/import/import_flat.c:226:15
SUMMARY: AddressSanitizer: heap-buffer-overflow in strncmp
E2
expect_status 0 'a timeout in the library is attributed to the library' <<'E2'
==1== ERROR: libFuzzer: timeout after 60 seconds
    #0 0x5 in __sanitizer_print_stack_trace (build/fuzz/fuzz_scene+0x1)
    #1 0x7 (/lib/libassimp.so.5+0x1)
E2
expect_status 1 'a crash of our code in memory of the library is attributed to our code' <<'E2'
==1==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x6
    #0 0x5 in memcpy (build/fuzz/fuzz_scene+0xd8ffc)
    #1 0x5 in take_points platform/ctl/import/import_flat.c:26:15

0x6 is located 0 bytes after a region allocated by thread T0 here:
    #0 0x5 in malloc (build/fuzz/fuzz_scene+0x2)
    #1 0x7 (/lib/libassimp.so.5+0x7477d2)
SUMMARY: AddressSanitizer: heap-buffer-overflow in memcpy
E2
expect_status 1 'a log without a crash is attributed to our code' <<'E2'
#2 INITED cov: 12
    #1 0x7 (/lib/libassimp.so.5+0x7477d2)
E2
echo "1..$count"
