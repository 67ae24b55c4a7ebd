# drivers.sh -- the drivers for USB disks, which are loaded only while the update page is open. kingyo-update, the scripts that
# build an image, and a test source this file.
# shellcheck shell=dash disable=SC2034  # the sourcing scripts use the variables
usb_disk_modules='usb-storage uas sd_mod vfat exfat nls_cp437 nls_ascii nls_iso8859-1 nls_utf8'
usb_disk_folder=/usr/lib/modules/usb-disk loaded=/proc/modules

# Unloads the drivers. A driver stays in use for a moment: while udev reads a new stick, and until the kernel has released
# the mount of a service that has ended. Returns 1 if a driver is still loaded after 20 s.
drivers_unload() {
    drivers_seconds=20
    while :; do
        for driver in $usb_disk_modules; do
            modprobe -q -r -d $usb_disk_folder "$driver" 2>/dev/null
        done
        grep -qE "^($(echo "$usb_disk_modules" | tr ' -' '|_')) " "$loaded" || return 0
        [ "$drivers_seconds" -gt 0 ] || return 1
        drivers_seconds=$((drivers_seconds - 1))
        sleep 1
    done
}
