#!/bin/bash
# test_device_rules.sh -- which group board/udev gives devices to, and which user board/sysusers
# creates. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
cd "$(dirname "$0")/../.." || exit 1

rules=board/udev/70-kingyo.rules gpio=board/udev/71-kingyo-gpio.rules
gets() { # RULES DEVICE WHAT
    local got
    got=$(awk -v device="$2" -f tests/board/udev.awk "$1" | tr '\n' ' ') || return 1
    echo "got '$got', expected '$3'"
    [ "${got% }" = "$3" ]
}
usb() { echo "ACTION=add;SUBSYSTEM=usb;ENV{DEVTYPE}=usb_device;ATTRS{idVendor}=$1;ATTRS{idProduct}=$2;power/control="; }
ours='GROUP=kingyo MODE=0660'

# ---- Controllers
for id in 1209:0001 054c:05c4 054c:09cc 054c:0ba0 054c:0ce6 054c:0df2 256f:c62e 256f:c635 046d:c626 046d:c62b; do
    check "controller $id belongs to the kiosk and is not suspended" \
        gets $rules "$(usb "${id%:*}" "${id#*:}")" "$ours ATTR{power/control}=on"
done
check 'the hidraw node of a controller belongs to the kiosk' gets $rules \
    'ACTION=add;SUBSYSTEM=hidraw;ATTRS{idVendor}=054c;ATTRS{idProduct}=0ce6;power/control=' "$ours"
check 'a triggered controller belongs to the kiosk' gets $rules "$(usb 054c 0ce6 | sed s/add/change/)" "$ours ATTR{power/control}=on"
check 'the rules skip a missing power control file' gets $rules "$(usb 054c 0ce6 | sed 's/;power.*//')" "$ours"
for id in 046d:c31c 046d:0ce6 054c:0001 1209:0002 1d6b:0002 054c:0ce61 '*:*'; do
    check "unlisted device $id belongs to root" gets $rules "$(usb "${id%:*}" "${id#*:}")" ''
done
check 'a USB interface is ignored' gets $rules "$(usb 054c 0ce6 | sed s/usb_device/usb_interface/)" ''
check 'an event node is ignored' gets $rules "$(usb 054c 0ce6 | sed s/SUBSYSTEM=usb/SUBSYSTEM=input/)" ''
check 'a removed controller is ignored' gets $rules "$(usb 054c 0ce6 | sed s/add/remove/)" ''

# ---- GPIO
check 'a GPIO chip belongs to the kiosk' gets $gpio 'ACTION=add;SUBSYSTEM=gpio;KERNEL=gpiochip0' "$ours"
check 'GPIO chip 12 belongs to the kiosk' gets $gpio 'ACTION=add;SUBSYSTEM=gpio;KERNEL=gpiochip12' "$ours"
check 'a sysfs GPIO line is ignored' gets $gpio 'ACTION=add;SUBSYSTEM=gpio;KERNEL=gpio17' ''
check 'a GPIO chip of another subsystem is ignored' gets $gpio 'ACTION=add;SUBSYSTEM=block;KERNEL=gpiochip0' ''

# ---- Properties of the rules
before_73() { for file in board/udev/*; do [[ $file =~ /([0-9]{2})-[a-z-]+\.rules$ ]] && [ "${BASH_REMATCH[1]}" -lt 73 ] || return 1; done; }
check 'the rules sort before 73-seat-late.rules' before_73
nothing_more() { ! grep -vE '^#' board/udev/* | grep -E '0?66[1-9]|0?777|RUN|PROGRAM|IMPORT|OWNER|uaccess|SYMLINK'; }
check 'the rules run no program and give nothing to everybody' nothing_more
ids_are_ids() { ! grep -oE 'ATTRS\{id[A-Za-z]+\}=="[^"]*"' $rules | grep -vE '=="[0-9a-f]{4}(\|[0-9a-f]{4})*"$'; }
check 'every id has four digits and no pattern' ids_are_ids
known_are_listed() { # The rules list every USB controller with a built-in mapping.
    local id count=0
    for id in $(sed -nE 's/^ *\{ SONY, 0x([0-9a-f]{4}),.*/\1/p' drivers/hid/hid_mapping.c); do
        gets $rules "$(usb 054c "$id")" "$ours ATTR{power/control}=on" || { echo "$id"; return 1; }
        count=$((count + 1))
    done
    [ $count -ge 5 ]
}
check 'every controller with a built-in mapping is listed' known_are_listed
if udevadm verify --help >"$work/help" 2>&1; then
    check 'udevadm verify finds no mistake' udevadm verify --resolve-names=never board/udev/*.rules
else
    skip 'udevadm verify finds no mistake' 'udevadm has no verify here (systemd 254 brought it)'
fi

# ---- The kiosk's user
if command -v systemd-sysusers >"$work/which"; then
    mkdir -p "$work/root/etc"
    printf 'root:x:0:0:root:/root:/bin/sh\n' >"$work/root/etc/passwd"
    printf 'root:x:0:\naudio:x:29:\n' >"$work/root/etc/group"
    makes() { systemd-sysusers --root="$work/root" - <board/sysusers/kingyo.conf; }
    # shellcheck disable=SC2317
    is_so() { grep -qE "$1" "$work/root/etc/$2" || { cat "$work/root/etc/$2"; return 1; }; }
    check 'systemd-sysusers creates the user' makes
    check 'the user has no shell, and its home is /var/lib/kingyo' is_so '^kingyo:x:[0-9]+:[0-9]+:Kingyo[^:]*:/var/lib/kingyo:/usr/sbin/nologin$' passwd
    check 'the user is a system user' awk -F: '$1 == "kingyo" { found = $3 < 1000 } END { exit !found }' "$work/root/etc/passwd"
    check 'the user has a group of the same name' is_so '^kingyo:x:[0-9]+:$' group
    for group in video render audio input gpio; do
        check "the user is a member of $group" is_so "^$group:x:[0-9]+:kingyo$" group
    done
    check 'a second run of systemd-sysusers succeeds' makes
else
    skip 'systemd-sysusers creates the user' 'there is no systemd-sysusers'
fi
echo "1..$count"
