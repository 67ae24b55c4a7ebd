# poi.sh -- our own poi on a virtual cable: dummy_hcd is both the host and the device side.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # init sources all files of this folder
poi_ids=1209:0001
poi_gadget="sh $host/bin/kingyo-poi-gadget"

poi_make() {
    modprobe usbhid
    modprobe hid-generic
    modprobe dummy_hcd
    modprobe libcomposite
    modprobe usb_f_hid
    $poi_gadget start VENDOR=0x1209 PRODUCT=0x0001 SERIAL=KINGYO-VM ${poi_udc:+UDC=$poi_udc} >>$host/out/poi.log 2>&1
    started=$?
    await 10 test -e /dev/hidraw0
    found $started gadget "$(lsusb 2>/dev/null | grep -i $poi_ids | cut -d: -f2-)"
    await 10 test -e /dev/hidg0
    udevadm settle --timeout=10
    poi_is_timed
    poi_hold
}

# Measures the time from a report to its tick without drawing, at the default rate of our poi.
poi_is_timed() {
    kingyo-poi run --simulate --device /dev/hidg0 2>$host/out/simulated.log &
    simulated=$!
    as kingyo lag $poi_ids 10 >$host/out/lag 2>&1
    found $? lag "$(tail -n 1 $host/out/lag)"
    kill -TERM $simulated
    wait $simulated
    await 10 test -e /dev/hidraw0
    udevadm settle --timeout=10
}

# Simulates the player: the poi rests before the tank until the host sends a motion.
poi_hold() {
    rm -f /tmp/way
    mkfifo /tmp/way
    kingyo-poi run --script --rate 120 --device /dev/hidg0 </tmp/way 2>>$host/out/poi.log &
    poi=$!
    (
        echo '0 140 400 0 17 0'
        while :; do
            if [ -e $host/plan ]; then
                cat $host/plan
                rm $host/plan
            fi
            sleep 0.03
        done
    ) >/tmp/way &
    feeder=$!
}

# Checks that our udev rules gave the poi and the lines to the kiosk's group, and that they disable
# the suspend of the poi.
poi_is_given() {
    udevadm settle --timeout=10
    device=$(grep -l ^1209 /sys/bus/usb/devices/*/idVendor | head -n 1)
    device=${device%/idVendor}
    node=/dev/bus/usb/$(printf '%03d/%03d' "$(cat "$device/busnum")" "$(cat "$device/devnum")")
    given=$(stat -c '%G %a' "$node" /dev/hidraw0 /dev/gpiochip0 | sort -u)
    [ "$given" = 'kingyo 660' ] && [ "$(cat "$device/power/control")" = on ]
    found $? rules "$node, hidraw0, gpiochip0: $given; power $(cat "$device/power/control")"
}

# Before the kiosk opens the poi: hid watch identifies the device node and prints its reports, and
# doctor reports the poi and the lines.
poi_is_watched() {
    await 10 test -e /dev/hidraw0
    as kingyo kingyoctl hid watch >$host/out/watched 2>&1
    grep -q "^/dev/hidraw0.${poi_ids}.USB.hid-generic.ok" $host/out/watched &&
        as kingyo kingyoctl hid watch /dev/hidraw0 --seconds 2 >>$host/out/watched 2>&1 &&
        [ "$(grep -c 0001:0030 $host/out/watched)" -ge 20 ]
    found $? watch "$(grep -c 0001:0030 $host/out/watched) reports in 2 s, from $(grep -m 1 -o '/dev/hidraw0.*' $host/out/watched | tr '\t' ' ')"
    as kingyo kingyoctl doctor --usb $poi_ids --line start=START --data /tmp/data >$host/out/doctor 2>&1
    grep -q "usb .*$poi_ids .*: plays (our own poi)" $host/out/doctor &&
        grep -q 'line .*start on START: on cabinet, line 0, free' $host/out/doctor
    found $? doctor "$(tail -n 1 $host/out/doctor)"
}

poi_unplug() { $poi_gadget detach >>$host/out/poi.log 2>&1; }
poi_plug() { $poi_gadget attach ${poi_udc:+UDC=$poi_udc} >>$host/out/poi.log 2>&1; }

# Returns 0 if the kiosk has claimed the poi through libusb, instead of the kernel's driver.
poi_is_taken() {
    set -- /sys/bus/usb/drivers/usbfs/*:1.0
    [ -e "$1" ]
}

poi_stop() {
    kill $feeder
    kill -TERM $poi
    wait $poi
    ended=$?
    received=$(sed -n 's/.*; \([0-9]*\) force feedback reports received, 0 rejected$/\1/p' $host/out/poi.log | tail -n 1)
    [ $ended -eq 0 ] && [ "${received:-0}" -gt 0 ]
    found $? haptics "$(tail -n 1 $host/out/poi.log)"
    $poi_gadget stop >>$host/out/poi.log 2>&1
}
