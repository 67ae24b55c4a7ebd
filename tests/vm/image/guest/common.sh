# common.sh -- what the parts of the test share in a machine that systemd runs.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # who sources it uses them
host=/run/host
export PATH=/run/host/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root
. $host/guest/lib.sh
. $host/guest/cabinet.sh
. $host/guest/poi.sh
poi_udc=dummy_udc.0

# The modules are there before the disk's own first program is (rdinit).
modprobe() { :; }

is_held() { # NAME: whether the kiosk has the line in its hand
    grep -qE "\($1 +\|kingyo" /sys/kernel/debug/gpio
}

poi_plug_in() {
    $poi_gadget start VENDOR=0x1209 PRODUCT=0x0001 SERIAL=KINGYO-VM UDC=$poi_udc >>$host/out/poi.log 2>&1
    await 20 test -e /dev/hidg0
}

asked() { # PROPERTY: of the stall's unit
    systemctl show -P "$1" kingyo.service
}

is_open() { # Whether the stall plays: READY=1 comes after its first picture.
    [ "$(asked ActiveState)" = active ] && [ "$(asked MainPID)" != 0 ]
}

opened_ms() { # When it did, since power on.
    echo $(($(asked ActiveEnterTimestampMonotonic) / 1000))
}

# Since the stall began anew, it writes another recording: the machine outside follows that one.
follow() {
    say "recording play-$(asked MainPID).kgr"
    rm -f $host/seen
    await 60 test -s $host/seen
}

read_count() { # NAME: what the machine outside says of the recording (look.c), a moment ago
    sed -n "s/^$1 //p" $host/seen 2>/dev/null
}

reads() { # NAME OPERATOR NUMBER
    test "$(read_count "$1")" "$2" "$3" 2>/dev/null
}

keep_shaders() { # For the next machine; whole, or not at all.
    cp -r /var/cache/kingyo/mesa_shader_cache $host/out/mesa.new 2>/dev/null && rm -rf $host/out/mesa &&
        mv $host/out/mesa.new $host/out/mesa
}
