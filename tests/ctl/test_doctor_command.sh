#!/bin/bash
# test_doctor_command.sh -- `kingyoctl doctor` on a machine that is simulated by files: which
# controllers can play, what prevents them, and the advice. Speaks TAP.
# shellcheck disable=SC2034,SC2154,SC1091  # lib.sh and doctor.sh use and set these variables
. "$(dirname "$0")/../lib.sh"
. "$(dirname "$0")/doctor.sh"
good=tests/hid/good/descriptors
unhex() { tr -d ' \n' | tr a-f A-F | basenc --base16 -d; }
device() { # PORT CLASS VENDOR PRODUCT NUMBER NAME: Adds a USB device to the simulated machine.
    local at=sys/bus/usb/devices/$1
    put "$at/bDeviceClass" "$2"
    put "$at/idVendor" "$3"
    put "$at/idProduct" "$4"
    put "$at/busnum" 1
    put "$at/devnum" "$5"
    put "$at/bConfigurationValue" 1
    put "$at/product" "$6"
    put "$at/power/control" "${7:-on}"
    put "dev/bus/usb/001/00$5" ''
    chmod 600 "$root/dev/bus/usb/001/00$5"
}
# PORT NUMBER CLASS SUBCLASS PROTOCOL DRIVER [DESCRIPTOR]: Adds an interface to the USB device at PORT. An empty DRIVER
# means that no driver is bound.
interface() {
    local at=sys/bus/usb/devices/$1:1.$2
    put "$at/bInterfaceNumber" "0$2"
    put "$at/bInterfaceClass" "$3"
    put "$at/bInterfaceSubClass" "$4"
    put "$at/bInterfaceProtocol" "$5"
    [ -z "$6" ] || { mkdir -p "$root/sys/bus/usb/drivers/$6"; ln -s "$root/sys/bus/usb/drivers/$6" "$root/$at/driver"; }
    if [ -n "${7:-}" ]; then
        mkdir -p "$root/$at/0003:0000:0000.0001"
        unhex <"$7" >"$root/$at/0003:0000:0000.0001/report_descriptor"
    fi
}

# ---- An empty machine
mkdir -p "$root"
check 'a machine without a screen is wrong' finds wrong display screens 'no screen is plugged in' 'connect a screen'
check 'a machine without USB is reported' finds check usb controllers 'no USB' 'plug in a controller'
check 'a machine without a sound card is reported' finds check sound cards 'no sound card: the kiosk is silent' 'connect a sound card'
check 'a data folder that does not exist yet is fine' finds fine store "data" 'does not exist yet'
exits() { local code=$1; shift; doctor "$@"; [ $? -eq "$code" ]; }
check 'a finding of level wrong exits with 1' exits 1

# ---- Controllers
device 1-1 09 1d6b 0002 1 'Hub'
device 1-1.1 00 054c 0ce6 2 'DualSense Wireless Controller' auto
interface 1-1.1 0 01 01 00 snd-usb-audio
interface 1-1.1 3 03 00 00 usbhid $good/016-ci-dualsense.hid
device 1-1.2 00 046d c31c 3 'Keyboard'
interface 1-1.2 0 03 01 01 usbhid tests/ctl/keyboard.hid
device 1-2 ff 045e 028e 4 'Xbox 360 Controller'
interface 1-2 0 ff 5d 01 xpad
device 1-3 00 0781 5567 5 'Cruzer'
interface 1-3 0 08 06 50 usb-storage
check 'a controller without permission is reported with advice' finds check usb '054c:0ce6 DualSense.*port 1-1.1' \
    'nobody may not open it: /dev/bus/usb/001/002: Permission denied' 'sudo cp board/udev/.*rules /etc/udev/rules.d/ and replug it; nobody must be in group kingyo.*usermod -aG kingyo nobody'
with=(--usb 054c:0ce6)
check 'a requested controller without permission is wrong' finds wrong usb 054c:0ce6 'nobody may not open it' 'sudo cp'
chmod 666 "$root/dev/bus/usb/001/002"
check 'a controller that autosuspend may stop is reported' finds check usb 054c:0ce6 \
    'plays \(a known controller\), but autosuspend may stop it' 'sudo cp board/udev/.*echo on . sudo tee /sys/bus/usb/devices/1-1.1/power/control'
put sys/bus/usb/devices/1-1.1/power/control on
check 'a requested controller without problems is fine' finds fine usb 054c:0ce6 'plays \(a known controller\)'
with=()
check 'a controller that nobody selected is reported with the option that selects it' finds fine usb 054c:0ce6 'may play' 'select it .*--usb 054c:0ce6'
put data/usb.txt 'plays 054c:0ce6'
check 'a controller that was selected in the menu is fine' finds fine usb 054c:0ce6 'plays \(a known controller\)'
rm "$root/sys/bus/usb/devices/1-1.1:1.3/driver"
ln -s /sys/bus/usb/drivers/usbfs "$root/sys/bus/usb/devices/1-1.1:1.3/driver"
check 'a controller that another program claimed is wrong, and the advice finds the program' finds wrong usb 054c:0ce6 \
    'another program has claimed it' 'end that program; sudo fuser -v /dev/bus/usb/001/002'
put proc/4711/comm kingyo
check 'a controller that the running kiosk claimed is fine' finds fine usb 054c:0ce6 'claimed, by the running kiosk'
rm -r "$root/proc/4711"
ln -sfn /sys/bus/usb/drivers/odd "$root/sys/bus/usb/devices/1-1.1:1.3/driver"
check 'a controller with a kernel driver is fine' finds fine usb 054c:0ce6 'plays'
rm "$root/sys/bus/usb/devices/1-1.1:1.3/driver"
check 'a controller without a driver is fine' finds fine usb 054c:0ce6 'plays'
mv "$root/sys/bus/usb/devices/1-1.1:1.3/0003:0000:0000.0001" "$work/hid"
check 'a controller with an unread descriptor is reported as examined later' finds fine usb 054c:0ce6 'is examined when the kiosk starts \(its motions are known'
mv "$work/hid" "$root/sys/bus/usb/devices/1-1.1:1.3/0003:0000:0000.0001"
with=(--usb dead:beef)
check 'a requested controller that is not plugged in is wrong' finds wrong usb dead:beef 'is not plugged in' 'plug it in'
with=(--usb 046d:c31c)
check 'a requested keyboard is reported as never claimed' finds check usb 046d:c31c 'was requested, but .*the kiosk never claims a keyboard'
with=()
check "an Xbox pad is reported with its driver" finds fine usb 045e:028e 'plays as a pad, through SDL'
check 'a memory stick is reported as no controller' finds fine usb 0781:5567 'is not a controller; driver usb-storage'
device 1-4 00 256c 006e 7 Tablet auto
interface 1-4 0 03 00 00 usbhid $good/137-dg-huion-h610-if0.hid
own_rule='put into .*71-kingyo-local.rules.*ATTR\{idProduct\}=="006e", GROUP="kingyo", MODE="0660", ATTR\{power/control\}="on"'
check 'a controller outside our udev rules needs a local rule' finds check usb 256c:006e 'may not open it' "$own_rule; nobody must be"
chmod 666 "$root/dev/bus/usb/001/007"
check 'the local rule also disables autosuspend' finds check usb 256c:006e 'autosuspend may stop it' "$own_rule, or for now: echo on"
rm -r "$root"/sys/bus/usb/devices/1-4*
listed() { # doctor_usb.c lists exactly the ids of the udev rules.
    sed -nE 's/^ATTRS\{idVendor\}=="(.*)", ATTRS\{idProduct\}=="(.*)", GOTO.*/\1 \2/p' board/udev/70-kingyo.rules |
        while read -r vendor products; do for product in ${products//|/ }; do echo "$vendor $product"; done; done |
        sort >"$work/rules"
    grep -oE '\{ 0x[0-9a-f]{4}, 0x[0-9a-f]{4} \}' platform/ctl/doctor/doctor_usb.c | sed -E 's/[^ ]*0x|[{},]//g; s/^ +//; s/ +$//' |
        tr -s ' ' | sort | diff - "$work/rules"
}
check 'doctor lists the same controllers as the udev rules' listed
ln -s "$root/gone" "$root/sys/bus/usb/devices/1-7"
check 'a port without readable data is reported' finds check usb 'port 1-7' 'has no readable data'
rm "$root/sys/bus/usb/devices/1-7"
no_hub() { doctor; ! grep -q Hub "$work/out"; }
check 'hubs are omitted' no_hub
put sys/class/hidraw/hidraw0/device/uevent 'HID_ID=0005:0000054C:00000CE6
HID_NAME=Wireless	Controller'
check 'a Bluetooth controller with a tab in its name is fine and stays in one row' finds fine hid '054c:0ce6 Wireless.Controller' 'by Bluetooth: plays through SDL'

put sys/class/input/event2/device/name 'Touch screen'
put sys/class/input/event10/device/name 'Gamepad'
put dev/input/event2 ''
put dev/input/event10 ''
chmod 600 "$root/dev/input/event2"
chmod 666 "$root/dev/input/event10"
check 'an event node that SDL cannot read is wrong without a desktop' finds wrong input 'Touch screen, /dev/input/event2' \
    'nobody may not read it' 'sudo usermod -aG input nobody'
check 'an event node that SDL can read is fine' finds fine input 'Gamepad, /dev/input/event10' 'nobody may read it'
chmod 666 "$root/dev/input/event2"

# ---- Lines
put dev/gpiochip0 ''
chmod 600 "$root/dev/gpiochip0"
check 'an unused GPIO chip without permission is reported' finds check gpio /dev/gpiochip0 'nobody may not open it: Permission denied' 'sudo cp board/udev'
ln -s gpiochip0 "$root/dev/gpiochip4" # Raspberry Pi OS creates this link.
check 'a link to a GPIO chip is not reported as a second chip' finds check gpio /dev/gpiochip 'nobody may not open it'
with=(--line start=BTN_START)
check 'a required GPIO chip without permission is wrong' finds wrong gpio /dev/gpiochip0 'nobody may not open it' 'sudo cp board/udev'
check 'a line of a closed GPIO chip is reported as not found' finds wrong line 'start on BTN_START' 'no chip that may be opened has this line' 'correct --line'
with=()

# ---- Screen and sound
put sys/class/drm/card1-HDMI-A-1/status connected
put sys/class/drm/card1-HDMI-A-1/modes 1920x1080
put sys/class/drm/card1-HDMI-A-2/status disconnected
put dev/dri/card1 ''
put dev/dri/renderD128 ''
chmod 600 "$root/dev/dri/card1"
chmod 666 "$root/dev/dri/renderD128"
check 'a screen is reported with its resolution' finds fine display card1-HDMI-A-1 'connected, 1920x1080'
check 'a connector without a screen is reported' finds fine display card1-HDMI-A-2 disconnected
check 'a graphics card without permission is wrong, and the advice names the group' finds wrong display /dev/dri/card1 'nobody may not use it' 'sudo usermod -aG video nobody'
check 'an accessible render node is fine' finds fine display /dev/dri/renderD128 'nobody may use it'
put proc/asound/cards ' 0 [PCH            ]: HDA-Intel - HDA Intel PCH
                      HDA Intel PCH at 0xa1 irq 130'
put dev/snd/pcmC0D0p ''
chmod 600 "$root/dev/snd/pcmC0D0p"
check 'a sound card is reported by name' finds fine sound 'card 0' 'HDA-Intel - HDA Intel PCH'
check 'a sound output without permission is wrong, and the advice names the group' finds wrong sound /dev/snd/pcmC0D0p 'may not use it' 'sudo usermod -aG audio nobody'
if [ "$(id -u)" -eq 0 ]; then
    chown :daemon "$root/dev/snd/pcmC0D0p"
    chmod 660 "$root/dev/snd/pcmC0D0p"
    check 'the advice names the group of the device node' finds wrong sound /dev/snd/pcmC0D0p . 'sudo usermod -aG daemon nobody'
fi
chmod 666 "$root/dev/snd/pcmC0D0p" "$root/dev/dri/card1"

# ---- Store
chmod 755 "$root/data"
check 'a data folder without write permission is wrong' finds wrong store /data 'nobody may not write there' "sudo chown -R nobody '/data'"
chmod 777 "$root/data"
check 'a writable data folder is fine' finds fine store /data 'nobody may write there'
check 'the free space is reported' finds '(fine|check)' store room '[0-9]+ MiB are free'
check 'a missing database is fine' finds fine database kingyo.db 'has saved nothing'
cp tests/unit/platform/store/files/version-6.db "$root/data/kingyo.db"
check 'a database is checked and summarized' finds fine database kingyo.db 'whole, version 6: 9 entries of 2 starts, 1 rounds'
cp tests/unit/platform/store/files/version-2.db "$root/data/kingyo.db"
check 'a database of an earlier version is fine' finds fine database kingyo.db 'of an earlier version'
# The kiosk would rename each of these files, so `kingyoctl doctor` must report each as damaged.
foreign_is_wrong() { # VERSION SQL
    cp "tests/unit/platform/store/files/version-$1.db" "$root/data/kingyo.db" && sqlite3 "$root/data/kingyo.db" "$2" &&
        finds wrong database kingyo.db "damaged: holds the trigger 't', which is not Kingyo's" 'restart the kiosk'
}
for version in 1 2 3 4 5 6; do
    check "a database of version $version with a trigger is wrong" foreign_is_wrong $version \
        'create trigger t after update on rounds begin delete from rounds; end'
done
cp tests/unit/platform/store/files/version-5.db "$root/data/kingyo.db"
printf 'x%.0s' {1..4000} | dd of="$root/data/kingyo.db" bs=1 seek=4096 conv=notrunc status=none
check 'a damaged database of an earlier version is wrong' finds wrong database kingyo.db damaged 'restart the kiosk'
rm "$root/data/kingyo.db" && sqlite3 "$root/data/kingyo.db" 'create table x (a)'
check 'the database of another program is wrong' finds wrong database kingyo.db damaged 'restart the kiosk'
touch "$root/data/kingyo.db.damaged-1" "$root/data/kingyo.db.damaged-1-wal"
touch -d '3 days ago' "$root/data/kingyo.db.backup"
check 'a renamed damaged database is reported' finds check database kingyo.db.damaged-1 'was renamed'
check 'a backup is reported with its age' finds check backup kingyo.db.backup '72 h old'
rm "$root"/data/kingyo.db.*
head -c 5000 /dev/urandom >"$root/data/kingyo.db"
check 'a damaged database is wrong' finds wrong database kingyo.db damaged 'restart the kiosk'
rm "$root/data/kingyo.db"
# The kiosk follows no link, and chown would change the file to which the link leads.
for target in nowhere other.db; do
    ln -s "$target" "$root/data/kingyo.db"
    check "a link to $target in place of the database is wrong" finds wrong database kingyo.db 'is a symbolic link' 'move the database itself'
    rm "$root/data/kingyo.db"
    cp tests/unit/platform/store/files/version-6.db "$root/data/other.db"
done
mkfifo "$root/data/kingyo.db" "$root/data/kingyo.db.backup"
check 'a FIFO in place of the database is wrong' finds wrong database kingyo.db 'is not a regular file' 'restart the kiosk'
check 'a FIFO in place of the backup is reported' finds check backup kingyo.db.backup 'is not a regular file' 'restart the kiosk'
rm "$root/data/kingyo.db" "$root/data/kingyo.db.backup" "$root/data/other.db"
put data/pois/054c-0ce6-A.poi 'something else'
check 'an unreadable controller mapping is reported with its line' finds check learned 054c-0ce6-A.poi 'line 1: ' 'remove the file, and learn the controller again'
rm "$root/data/pois/054c-0ce6-A.poi"

# ---- Configuration
printf 'fish = 300\nfish = many\n' >"$work/kingyo.conf"
with=(--config "$work/kingyo.conf")
check 'a wrong line of the configuration is reported' finds wrong config kingyo.conf 'kingyo.conf:2: ' 'correct the line'
printf 'fish = 300\nusb = 054c:0ce6\n' >"$work/kingyo.conf"
rm "$root/data/usb.txt"
check 'a valid configuration is fine' finds fine config kingyo.conf 'every line is used'
check 'a controller that the configuration selects is fine' finds fine usb 054c:0ce6 'plays \(a known controller\)'
with=()
put etc/kingyo/kingyo.conf '[money]
price = 30'
check 'the default configuration path is checked when --config is missing' finds wrong config etc/kingyo/kingyo.conf 'kingyo.conf:2: price: wrong value .30.; expected 1 to 20' 'correct the line'
rm -r "$root/etc/kingyo"
check 'a machine without a finding of level wrong exits with 0' exits 0
text_has_total() { doctor; tail -1 "$work/out" | grep -qE '^[0-9]+ fine, [0-9]+ to check, 0 wrong$' && grep -qE '^check +gpio' "$work/out" && grep -qE '^ +-> sudo cp' "$work/out"; }
check 'the text has one line for each finding and a total' text_has_total
touched() { [ "$(find "$root" -newer "$work/kingyo.conf" -type f -not -path '*/data/*' | wc -l)" -eq 0 ]; }
check 'doctor changes no file' touched

# ---- Arguments
refuses() { local code=$1; shift; doctor "$@"; [ $? -eq "$code" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && [ ! -s "$work/out" ] && grep -q '^kingyoctl doctor: ' "$work/err"; }
check 'an unknown option is wrong usage' refuses 2 --colour
check 'a missing value is wrong usage' refuses 2 --root
check 'an invalid line is wrong usage' refuses 2 --line nonsense
check 'an unknown user exits with 65' refuses 65 --user nobody-of-this-name
check 'a missing root folder exits with 74' refuses 74 --root "$work/none"
check 'a root that is a file exits with 74' refuses 74 --root "$work/kingyo.conf"
home_of() { # USER: The data folder is in the home of USER, not in the home of the caller.
    local home
    home=$(getent passwd "$1" | cut -d: -f6)
    HOME=/somebody/else "$ctl" doctor --root "$root" --user "$1" >"$work/out"
    grep -E ' store ' "$work/out"
    grep -qF "$root$home/.local/share/kingyo: " "$work/out" && ! grep -q somebody/else "$work/out"
}
check '--user selects the data folder of that user' home_of daemon
service_folder() { # UID: The service stores its data in the home folder of the account that board/sysusers makes.
    (grep -v '^kingyo:' /etc/passwd; echo "kingyo:x:$1:$1::/var/lib/kingyo:/usr/sbin/nologin") >"$work/passwd"
    unshare -m sh -c "mount --bind '$work/passwd' /etc/passwd && exec '$ctl' doctor --root '$root' --user kingyo" >"$work/out"
    grep -E ' store ' "$work/out"
    grep -qF "$root/var/lib/kingyo: " "$work/out"
}
while read -r uid text; do
    if [ "$(id -u)" -eq 0 ] && unshare -m true 2>/dev/null; then
        check "$text" service_folder "$uid" </dev/null
    else
        count=$((count + 1))
        echo "ok $count - $text # SKIP this needs root and a mount namespace"
    fi
done <<END
990 --user kingyo selects the service's data folder
$(id -u) --user kingyo selects it also for that user
END
check 'a missing configuration exits with 74' refuses 74 --config "$work/none.conf"
helps() { "$ctl" doctor --help | grep -q -- '--root FOLDER'; }
check '--help lists the options' helps
this_machine() { "$ctl" doctor --json >"$work/out"; [ $? -le 1 ] && [ "$(sqlite3 :memory: "select json_array_length(readfile('$work/out'), '\$.findings') > 3")" = 1 ]; }
check 'the real machine is checked without an error' this_machine
echo "1..$count"
