# hostile.sh -- a person with a keyboard or a malicious USB device must not affect the kiosk. One
# result for each attack.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # stall.sh sources this file
usb_gadget=/sys/kernel/config/usb_gadget/hostile

# Prints the state of the machine: the kiosk's process, the active console, disks, network cards
# and serial lines. A gadget's own network card is omitted, because only this test has the other
# end of the cable in the same machine.
private_state() {
    echo "$(unit_property MainPID) $(cat /sys/class/tty/tty0/active) $(ls /sys/block | tr '\n' ' ')"
    for net in /sys/class/net/*; do
        case $(readlink -f "$net") in */gadget*) ;; *) echo "${net##*/}" ;; esac
    done
    ls /dev/ttyACM* /dev/ttyUSB* 2>/dev/null
}

# Returns 0 if the state is unchanged, and no coin and no press were recorded except ours.
unmoved() {
    [ "$(private_state)" = "$before" ] &&
        reads coins -eq "$coins_before" && reads test -eq "$tests_before" && reads start -eq "$presses_before"
}

save_state() {
    before=$(private_state)
    coins_before=$(read_count coins)
    tests_before=$(read_count test)
    presses_before=$(read_count start)
}

# Plugs in a device that the device side of the second cable simulates.
device_begin() { # VENDOR PRODUCT
    mkdir -p $usb_gadget/configs/c.1/strings/0x409 $usb_gadget/strings/0x409
    echo "$1" >$usb_gadget/idVendor
    echo "$2" >$usb_gadget/idProduct
    echo hostile >$usb_gadget/strings/0x409/product
}

device_has() { # FUNCTION
    mkdir -p "$usb_gadget/functions/$1"
    ln -s "$usb_gadget/functions/$1" "$usb_gadget/configs/c.1/"
}

device_in() {
    echo dummy_udc.1 >$usb_gadget/UDC
    udevadm settle --timeout=10
    sleep 2
}

device_out() {
    echo '' >$usb_gadget/UDC 2>/dev/null
    for function in "$usb_gadget"/configs/c.1/*.*; do
        [ ! -L "$function" ] || rm "$function"
    done
    rmdir "$usb_gadget"/functions/* "$usb_gadget"/configs/c.1/strings/0x409 "$usb_gadget"/configs/c.1 \
        "$usb_gadget"/strings/0x409 $usb_gadget 2>/dev/null
}

hid() { # PROTOCOL SUBCLASS LENGTH; the report descriptor comes on standard input
    mkdir -p $usb_gadget/functions/hid.hostile
    cat >$usb_gadget/functions/hid.hostile/report_desc
    echo "$1" >$usb_gadget/functions/hid.hostile/protocol
    echo "$2" >$usb_gadget/functions/hid.hostile/subclass
    echo "$3" >$usb_gadget/functions/hid.hostile/report_length
    device_has hid.hostile
}

keyboard_words() { # The report descriptor of a keyboard (HID 1.11, appendix B.1).
    printf '\005\001\011\006\241\001\005\007\031\340\051\347\025\000\045\001\165\001\225\010\201\002\225\001\165\010\201\003'
    printf '\225\006\165\010\025\000\045\145\005\007\031\000\051\145\201\000\300'
}

# Types 5 (a coin of a desktop kiosk), F2 (the operator's menu) and Escape twice (quit) on the
# simulated device.
device_types() { # DEVICE
    for key in 042 073 051 051; do
        printf '\000\000\'$key'\000\000\000\000\000' >"$1" &
        sleep 0.3
        printf '\000\000\000\000\000\000\000\000' >"$1" &
        sleep 0.3
    done
    kill $! 2>/dev/null
}

hidg_of_device() {
    for node in /dev/hidg*; do
        [ "$node" != /dev/hidg0 ] && echo "$node"
    done
}

tried() { # ID WORDS
    sleep 2 # After this time the recording contains any effect.
    unmoved
    found $? "$1" "$2"
}

rm -f $host/keys-done
save_state
say 'keys' # The host types on a keyboard that is connected from the start.
await 60 test -e $host/keys-done
tried keys "$(cat $host/keys-done)"

for kind in 1:1 0:0; do # A boot keyboard, and a keyboard that does not declare itself as one.
    device_begin 0x046d 0xc31c
    keyboard_words | hid "${kind%:*}" "${kind#*:}" 8
    device_in
    device_types "$(hidg_of_device)"
    tried usb-keys "a keyboard with protocol ${kind%:*}: 5, F2, Esc, Esc"
    device_out
done

device_begin 0x0781 0x5581
dd if=/dev/zero of=/run/stick bs=1M count=4 2>/dev/null
mkdir -p $usb_gadget/functions/mass_storage.0
echo /run/stick >$usb_gadget/functions/mass_storage.0/lun.0/file
device_has mass_storage.0
device_in
tried usb-disk "block devices: $(ls /sys/block | tr '\n' ' ')"
device_out

for function in ecm.usb0 acm.0; do
    device_begin 0x0525 0xa4a2
    device_has $function
    device_in
    tried usb-net "${function%.*}: network cards and serial lines: $(private_state | tail -n +2 | tr '\n' ' ')"
    device_out
done

# Malformed report descriptors: random bytes, unclosed collections, a field of 2^32 bits, and 4,000
# random bytes.
for words in noise endless huge long; do
    device_begin 0x1209 0x0001 # The device has the id of our poi, so that the kiosk itself reads it.
    case $words in
        noise) dd if=/dev/urandom bs=64 count=1 2>/dev/null ;;
        endless) for _ in 1 2 3 4 5 6 7 8 9; do printf '\005\001\011\060\241\001\241\002\241\000'; done ;;
        huge) printf '\005\001\011\004\241\001\011\060\026\000\200\046\377\177\165\377\227\377\377\377\377\201\002\300' ;;
        long) dd if=/dev/urandom bs=4000 count=1 2>/dev/null ;;
    esac | hid 0 0 64
    device_in
    head -c 64 /dev/urandom >"$(hidg_of_device)" 2>/dev/null &
    sleep 1
    kill $! 2>/dev/null
    tried usb-lies "$words"
    device_out
done
found 0 usb-lies 'random bytes, unclosed collections, a field of 2^32 bits, 4,000 bytes: the kiosk continues'
