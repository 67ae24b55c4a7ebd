#!/bin/bash
# test_update_drivers.sh -- the drivers for USB disks are unloaded when the update page is closed, also if a program still
# uses one of them for some seconds. modprobe and sleep are replaced. Speaks TAP.
# shellcheck disable=SC2154,SC1091,SC2034  # the sourced files set and use these variables
. "$(dirname "$0")/../lib.sh"
cd "$(dirname "$0")/../.." || exit 1
. board/image/update/drivers.sh
loaded=$work/modules

# The kernel unloads a driver that is not in use. $busy is in use for $busy_s seconds.
modprobe() { # -q -r -d FOLDER DRIVER
    local name=${5//-/_}
    if [ "$name" = "$busy" ] && [ "$slept" -lt "$busy_s" ]; then return 1; fi
    sed -i "/^$name /d" "$loaded"
}
sleep() { slept=$((slept + 1)); }
fresh() { # DRIVER SECONDS in which it is in use
    busy=$1 busy_s=$2 slept=0
    printf '%s 65536 0 - Live 0x0\n' usb_storage uas sd_mod vfat nls_iso8859_1 snd_usb_audio >"$loaded"
}
is_left() { [ "$(cut -d' ' -f1 "$loaded" | tr '\n' ' ')" = "$1 " ]; }

at_once() { fresh none 0 && drivers_unload && is_left snd_usb_audio && [ "$slept" -eq 0 ]; }
check 'drivers that are not in use are unloaded at once, and no other module is' at_once
later() { fresh "$1" 7 && drivers_unload && is_left snd_usb_audio && [ "$slept" -eq 7 ]; }
for name in usb_storage sd_mod nls_iso8859_1; do
    check "$name is unloaded as soon as it is not in use" later $name
done
never() { fresh vfat 1000 && ! drivers_unload && is_left 'vfat snd_usb_audio' && [ "$slept" -eq 20 ]; }
check 'a driver that stays in use for 20 s is reported' never
echo "1..$count"
