#!/bin/bash
# test_hid_map.sh -- kingyoctl hid map says by what the kiosk would play a device.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
good=tests/hid/good/descriptors

says() { # WANTED COMMAND...: what it prints begins so
    local wanted=$1
    shift
    case $("$ctl" hid map "$@" 2>/dev/null) in "$wanted"*) ;; *) return 1 ;; esac
}
exits() { # CODE COMMAND...
    local code=$1 got=0
    shift
    "$ctl" hid map "$@" >/dev/null 2>"$work/error" || got=$?
    [ "$got" = "$code" ] && [ "$(wc -l <"$work/error")" -ge 1 ]
}
check 'a puck flies' says 'offered fly x=rate:1:s16@0' $good/002-3dconnexion-spacemouse-wireless.hid
check 'a pad of known ids is known' says 'known fly' $good/016-ci-dualsense.hid 054c:0ce6
check 'without them it is played by what it offers' says 'offered fly' $good/016-ci-dualsense.hid
check 'a pen points' says 'offered pointer x=place:7' $good/137-dg-huion-h610-if0.hid
check 'a keyboard is told to be none, with exit 1' exits 1 $good/041-hd-kye-0458-0138-1.hid
because() { "$ctl" hid map "$2" 2>&1 | grep -q "$1"; }
check 'with the reason' because 'keys of a keyboard' $good/041-hd-kye-0458-0138-1.hid
check 'a wheel has another' because 'not both' $good/031*.hid
check 'vendors numbers have another' because 'called X or Y; it may be learned' $good/057*.hid
check 'ids that are none are wrong usage' exits 2 $good/016-ci-dualsense.hid 054c
check 'a descriptor that is none is bad data' exits 65 tests/hid/malformed/M03-truncated-item-1of2.hid
check 'a file that is not there is an input error' exits 74 "$work/nowhere.hid"
echo "1..$count"
