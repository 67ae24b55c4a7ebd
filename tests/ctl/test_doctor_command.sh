#!/bin/bash
# test_doctor_command.sh -- `kingyoctl doctor` on a machine made of files: who may play, who is in the way, what to
# do. The user it asks for is nobody, so that the test says the same to root. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
root=$work/root
good=tests/hid/good/descriptors
unhex() { tr -d ' \n' | tr a-f A-F | basenc --base16 -d; }

doctor() { "$ctl" doctor --root "$root" --user nobody --data /data "$@" >"$work/out" 2>"$work/err"; }
# LEVEL PART WHAT STATE [ADVICE]: extended patterns; exactly one finding fits all of them.
finds() {
    doctor --json "${with[@]}"
    sqlite3 :memory: "select * from (select json_extract(value,'\$.level') as level, json_extract(value,'\$.part'),
        json_extract(value,'\$.what'), json_extract(value,'\$.state'), json_extract(value,'\$.todo')
        from json_each(readfile('$work/out'), '\$.findings'))" >"$work/rows"
    cat "$work/rows"
    [ "$(grep -cE "^$1\|$2\|[^|]*$3[^|]*\|[^|]*$4[^|]*\|${5:-}" "$work/rows")" -eq 1 ]
}
with=()
put() { # PATH TEXT
    mkdir -p "$(dirname "$root/$1")"
    printf '%s\n' "$2" >"$root/$1"
}
device() { # PORT CLASS VENDOR PRODUCT NUMBER NAME
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
interface() { # PORT NUMBER CLASS SUBCLASS PROTOCOL DRIVER [DESCRIPTOR]
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

# ---- Nothing at all
mkdir -p "$root"
check 'a machine without anything is told so' finds wrong display screens 'no screen is plugged in' 'plug one in'
check 'also that it has no USB' finds look usb controllers 'no USB' 'plug one in'
check 'and no sound' finds look sound cards 'none: the stall is silent' 'plug one in'
check 'a data folder that is not there yet is fine' finds fine store "data" 'is not there yet'
exits() { local code=$1; shift; doctor "$@"; [ $? -eq "$code" ]; }
check 'something wrong exits 1' exits 1

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
check 'a controller that may not be opened is one to look at' finds look usb '054c:0ce6 DualSense.*port 1-1.1' \
    'nobody may not open it: /dev/bus/usb/001/002: Permission denied' 'sudo cp board/udev/.*rules /etc/udev/rules.d/ and replug it; nobody must be in group kingyo.*usermod -aG kingyo nobody'
with=(--usb 054c:0ce6)
check 'and wrong where it is to play' finds wrong usb 054c:0ce6 'nobody may not open it' 'sudo cp'
chmod 666 "$root/dev/bus/usb/001/002"
check 'one that may fall asleep is one to look at' finds look usb 054c:0ce6 \
    'plays \(a controller we know\), but may fall asleep' 'sudo cp board/udev/.*echo on . sudo tee /sys/bus/usb/devices/1-1.1/power/control'
put sys/bus/usb/devices/1-1.1/power/control on
check 'else it is fine, and plays' finds fine usb 054c:0ce6 'plays \(a controller we know\)'
with=()
check 'one that nobody chose may play, and it is said how' finds fine usb 054c:0ce6 'may play' 'choose it .*--usb 054c:0ce6'
put data/usb.txt 'plays 054c:0ce6'
check 'one that was chosen in the menu plays' finds fine usb 054c:0ce6 'plays \(a controller we know\)'
rm "$root/sys/bus/usb/devices/1-1.1:1.3/driver"
ln -s /sys/bus/usb/drivers/usbfs "$root/sys/bus/usb/devices/1-1.1:1.3/driver"
check 'one that a program has claimed is wrong, and it is said how to find that' finds wrong usb 054c:0ce6 \
    'another program has claimed it' 'end that program; sudo fuser -v /dev/bus/usb/001/002'
put proc/4711/comm kingyo
check 'unless that program is the kiosk' finds fine usb 054c:0ce6 'claimed, by the running kiosk'
rm -r "$root/proc/4711"
ln -sfn /sys/bus/usb/drivers/odd "$root/sys/bus/usb/devices/1-1.1:1.3/driver"
check 'a kernel driver gives way' finds fine usb 054c:0ce6 'plays'
rm "$root/sys/bus/usb/devices/1-1.1:1.3/driver"
check 'without a driver it is free' finds fine usb 054c:0ce6 'plays'
mv "$root/sys/bus/usb/devices/1-1.1:1.3/0003:0000:0000.0001" "$work/hid"
check 'one whose descriptor nobody has read yet says so' finds fine usb 054c:0ce6 'is asked as soon as the kiosk starts \(it says how once'
mv "$work/hid" "$root/sys/bus/usb/devices/1-1.1:1.3/0003:0000:0000.0001"
with=(--usb dead:beef)
check 'one that was asked for and is not there is wrong' finds wrong usb dead:beef 'is not plugged in' 'plug it in'
with=(--usb 046d:c31c)
check 'a keyboard is never claimed, whoever names it, who hears so' finds look usb 046d:c31c 'was asked for, but .*a keyboard is never claimed'
with=()
check "an Xbox pad plays through its driver" finds fine usb 045e:028e 'plays as a pad, through SDL'
check 'a memory stick is no controller' finds fine usb 0781:5567 'is no controller; driver usb-storage'
device 1-4 00 256c 006e 7 Tablet auto
interface 1-4 0 03 00 00 usbhid $good/137-dg-huion-h610-if0.hid
own_rule='put into .*71-kingyo-local.rules.*ATTR\{idProduct\}=="006e", GROUP="kingyo", MODE="0660", ATTR\{power/control\}="on"'
check 'one that our rules do not list needs a line of its own' finds look usb 256c:006e 'may not open it' "$own_rule; nobody must be"
chmod 666 "$root/dev/bus/usb/001/007"
check 'also to stay awake' finds look usb 256c:006e 'may fall asleep' "$own_rule, or for now: echo on"
rm -r "$root"/sys/bus/usb/devices/1-4*
listed() { # Every id of the rules, and no other, is sent to them.
    sed -nE 's/^ATTRS\{idVendor\}=="(.*)", ATTRS\{idProduct\}=="(.*)", GOTO.*/\1 \2/p' board/udev/70-kingyo.rules |
        while read -r vendor products; do for product in ${products//|/ }; do echo "$vendor $product"; done; done |
        sort >"$work/rules"
    grep -oE '\{ 0x[0-9a-f]{4}, 0x[0-9a-f]{4} \}' platform/ctl/doctor/doctor_usb_read.c | sed -E 's/[^ ]*0x|[{},]//g; s/^ +//; s/ +$//' |
        tr -s ' ' | sort | diff - "$work/rules"
}
check 'doctor knows what our rules list' listed
ln -s "$root/gone" "$root/sys/bus/usb/devices/1-7"
check 'a port of which nothing can be read is one to look at' finds look usb 'port 1-7' 'says nothing of itself'
rm "$root/sys/bus/usb/devices/1-7"
no_hub() { doctor; ! grep -q Hub "$work/out"; }
check 'hubs are left out' no_hub
put sys/class/hidraw/hidraw0/device/uevent 'HID_ID=0005:0000054C:00000CE6
HID_NAME=Wireless	Controller'
check 'a controller by Bluetooth plays through SDL, and its name breaks no row' finds fine hid '054c:0ce6 Wireless.Controller' 'by Bluetooth: plays through SDL'

put sys/class/input/event2/device/name 'Touch screen'
put sys/class/input/event10/device/name 'Gamepad'
put dev/input/event2 ''
put dev/input/event10 ''
chmod 600 "$root/dev/input/event2"
chmod 666 "$root/dev/input/event10"
check 'an event node that SDL may not read is wrong without a desktop' finds wrong input 'Touch screen, /dev/input/event2' \
    'nobody may not read it' 'sudo usermod -aG input nobody'
check 'one that it may is fine' finds fine input 'Gamepad, /dev/input/event10' 'nobody may read it'
chmod 666 "$root/dev/input/event2"

# ---- Lines
put dev/gpiochip0 ''
chmod 600 "$root/dev/gpiochip0"
check 'a chip that nobody needs may stay closed' finds look gpio /dev/gpiochip0 'nobody may not open it: Permission denied' 'sudo cp board/udev'
ln -s gpiochip0 "$root/dev/gpiochip4" # As Raspberry Pi OS does.
check 'a link to it is no other one' finds look gpio /dev/gpiochip 'nobody may not open it'
with=(--line start=BTN_START)
check 'one that is needed may not' finds wrong gpio /dev/gpiochip0 'nobody may not open it' 'sudo cp board/udev'
check 'and its line is not found' finds wrong line 'start on BTN_START' 'no chip that may be opened has it' 'kingyoctl lines list'
with=()

# ---- Screen and sound
put sys/class/drm/card1-HDMI-A-1/status connected
put sys/class/drm/card1-HDMI-A-1/modes 1920x1080
put sys/class/drm/card1-HDMI-A-2/status disconnected
put dev/dri/card1 ''
put dev/dri/renderD128 ''
chmod 600 "$root/dev/dri/card1"
chmod 666 "$root/dev/dri/renderD128"
check 'a screen is named with its size' finds fine display card1-HDMI-A-1 'connected, 1920x1080'
check 'a socket without one too' finds fine display card1-HDMI-A-2 disconnected
check 'a card that may not be used is wrong, and which group helps' finds wrong display /dev/dri/card1 'nobody may not use it' 'sudo usermod -aG video nobody'
check 'a renderer that may be used is fine' finds fine display /dev/dri/renderD128 'nobody may use it'
put proc/asound/cards ' 0 [PCH            ]: HDA-Intel - HDA Intel PCH
                      HDA Intel PCH at 0xa1 irq 130'
put dev/snd/pcmC0D0p ''
chmod 600 "$root/dev/snd/pcmC0D0p"
check 'a sound card is named' finds fine sound 'card 0' 'HDA-Intel - HDA Intel PCH'
check 'its output needs a group' finds wrong sound /dev/snd/pcmC0D0p 'may not use it' 'sudo usermod -aG audio nobody'
if [ "$(id -u)" -eq 0 ]; then
    chown :daemon "$root/dev/snd/pcmC0D0p"
    chmod 660 "$root/dev/snd/pcmC0D0p"
    check 'the group that its node has is the one that is named' finds wrong sound /dev/snd/pcmC0D0p . 'sudo usermod -aG daemon nobody'
fi
chmod 666 "$root/dev/snd/pcmC0D0p" "$root/dev/dri/card1"

# ---- Store
chmod 755 "$root/data"
check 'a folder that may not be written is wrong' finds wrong store /data 'nobody may not write there' "sudo chown -R nobody '/data'"
chmod 777 "$root/data"
check 'one that may is fine' finds fine store /data 'nobody may write there'
check 'how much room there is, is said' finds '(fine|look)' store room '[0-9]+ MiB are free'
check 'no database yet is fine' finds fine database kingyo.db 'nothing was kept'
cp tests/unit/platform/store/files/version-5.db "$root/data/kingyo.db"
check 'a database is looked through' finds fine database kingyo.db 'whole, version 5: 9 entries of 2 starts, 1 rounds'
cp tests/unit/platform/store/files/version-2.db "$root/data/kingyo.db"
check 'an earlier one is brought up to date by the stall' finds fine database kingyo.db 'of an earlier version'
touch "$root/data/kingyo.db.damaged-1" "$root/data/kingyo.db.damaged-1-wal"
touch -d '3 days ago' "$root/data/kingyo.db.backup"
check 'one that was set aside is to be looked at' finds look database kingyo.db.damaged-1 'set aside'
check 'a backup has an age' finds look backup kingyo.db.backup '72 h old'
rm "$root"/data/kingyo.db.*
head -c 5000 /dev/urandom >"$root/data/kingyo.db"
check 'a damaged one is wrong' finds wrong database kingyo.db damaged 'restart the stall'
rm "$root/data/kingyo.db"
put data/pois/054c-0ce6-A.poi 'something else'
check 'a learned controller that cannot be read is told with its line' finds look learned 054c-0ce6-A.poi 'line 1: ' 'remove it, and learn that controller again'
rm "$root/data/pois/054c-0ce6-A.poi"

# ---- Configuration
printf 'fish = 300\nfish = many\n' >"$work/kingyo.conf"
with=(--config "$work/kingyo.conf")
check 'a line of the configuration that cannot be used is told' finds wrong config kingyo.conf 'kingyo.conf:2: ' 'mend that line'
printf 'fish = 300\nusb = 054c:0ce6\n' >"$work/kingyo.conf"
rm "$root/data/usb.txt"
check 'a good one is fine' finds fine config kingyo.conf 'every line is used'
check 'and counts' finds fine usb 054c:0ce6 'plays \(a controller we know\)'
with=()
put etc/kingyo/kingyo.conf '[money]
price = 30'
check 'without one the machine'\''s own is read, as the kiosk reads it' finds wrong config etc/kingyo/kingyo.conf 'kingyo.conf:2: price: wrong value .30.; expected 1 to 20' 'mend that line'
rm -r "$root/etc/kingyo"
check 'with nothing wrong it exits 0' exits 0
text_says() { doctor; tail -1 "$work/out" | grep -qE '^[0-9]+ fine, [0-9]+ to look at, 0 wrong$' && grep -qE '^look +gpio' "$work/out" && grep -qE '^ +-> sudo cp' "$work/out"; }
check 'people get a line each and a sum' text_says
touched() { [ "$(find "$root" -newer "$work/kingyo.conf" -type f -not -path '*/data/*' | wc -l)" -eq 0 ]; }
check 'it touches nothing' touched

# ---- Words
refuses() { local code=$1; shift; doctor "$@"; [ $? -eq "$code" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && [ ! -s "$work/out" ] && grep -q '^kingyoctl doctor: ' "$work/err"; }
check 'an option that nobody knows is wrong usage' refuses 2 --colour
check 'a value that is missing too' refuses 2 --root
check 'a wire that is none too' refuses 2 --line nonsense
check 'a user that is not there is bad data' refuses 65 --user nobody-of-this-name
check 'a root that is not there is an I/O error' refuses 74 --root "$work/none"
check 'so is one that is a file' refuses 74 --root "$work/kingyo.conf"
home_of() { # USER: the store is in his home, not in that of who asks
    local home
    home=$(getent passwd "$1" | cut -d: -f6)
    HOME=/somebody/else "$ctl" doctor --root "$root" --user "$1" >"$work/out"
    grep -E ' store ' "$work/out"
    grep -qF "$root$home/.local/share/kingyo: " "$work/out" && ! grep -q somebody/else "$work/out"
}
check 'whose kiosk it is has a data folder of his own' home_of daemon
check 'a configuration that is not there is an I/O error' refuses 74 --config "$work/none.conf"
helps() { "$ctl" doctor --help | grep -q -- '--root FOLDER'; }
check 'help says what there is' helps
this_machine() { "$ctl" doctor --json >"$work/out"; [ $? -le 1 ] && [ "$(sqlite3 :memory: "select json_array_length(readfile('$work/out'), '\$.findings') > 3")" = 1 ]; }
check 'this very machine is looked at, whatever it is' this_machine
echo "1..$count"
