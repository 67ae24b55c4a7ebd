#!/bin/bash
# test_hid_map.sh -- kingyoctl hid map prints the mapping that the kiosk would use for a device.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
good=tests/hid/good/descriptors

begins_with() { # EXPECTED COMMAND...: The output begins with EXPECTED.
    local expected=$1
    shift
    case $("$ctl" hid map "$@" 2>/dev/null) in "$expected"*) ;; *) return 1 ;; esac
}
exits() { # CODE COMMAND...
    local code=$1 got=0
    shift
    "$ctl" hid map "$@" >/dev/null 2>"$work/error" || got=$?
    [ "$got" = "$code" ] && [ "$(wc -l <"$work/error")" -ge 1 ]
}
check 'a SpaceMouse gets a fly mapping' begins_with 'offered fly x=rate:1:s16@0' $good/002-3dconnexion-spacemouse-wireless.hid
check 'a pad with known ids gets a known mapping' begins_with 'known fly' $good/016-ci-dualsense.hid 054c:0ce6
check 'a pad without ids gets a mapping from its descriptor' begins_with 'offered fly' $good/016-ci-dualsense.hid
check 'a pen gets a pointer mapping' begins_with 'offered pointer x=place:7' $good/137-dg-huion-h610-if0.hid
check 'a keyboard gives exit code 1' exits 1 $good/041-hd-kye-0458-0138-1.hid
because() { "$ctl" hid map "$2" 2>&1 | grep -q "$1"; }
check 'a keyboard is rejected with the reason' because 'keys of a keyboard' $good/041-hd-kye-0458-0138-1.hid
check 'a steering wheel is rejected with another reason' because 'only one of the axes' $good/031*.hid
check 'vendor-defined values are rejected with another reason' because 'no X axis and no Y axis; learn it' $good/057*.hid
check 'invalid ids are wrong usage' exits 2 $good/016-ci-dualsense.hid 054c
check 'an invalid descriptor exits with 65' exits 65 tests/hid/malformed/M03-truncated-item-1of2.hid
check 'a missing file exits with 74' exits 74 "$work/nowhere.hid"
echo "1..$count"
