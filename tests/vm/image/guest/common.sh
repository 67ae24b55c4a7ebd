# common.sh -- shared functions of the test parts in a machine with systemd.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # the sourcing scripts use these variables
host=/run/host
export PATH=/run/host/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root
. $host/guest/lib.sh
. $host/guest/cabinet.sh
. $host/guest/poi.sh
poi_udc=dummy_udc.0

# guest/rdinit has loaded the modules before the init program of the disk ran.
modprobe() { :; }

# Linux 6.12 prints no names for the lines of gpio-sim, so the order of the lines identifies a line.
is_held() { # NAME: Returns 0 if the kiosk holds the line.
    local line
    line=$(wire "$1")
    sed -n '/gpio-sim/,/^$/s/^ gpio-[0-9]* *//p' /sys/kernel/debug/gpio |
        sed -n "$((${line##*sim_gpio} + 1))p" | grep -q kingyo
}

poi_plug_in() {
    $poi_gadget start VENDOR=0x1209 PRODUCT=0x0001 SERIAL=KINGYO-VM UDC=$poi_udc >>$host/out/poi.log 2>&1
    await 20 test -e /dev/hidg0
}

unit_property() { # PROPERTY: Prints a property of the kiosk's unit.
    systemctl show -P "$1" kingyo.service
}

is_open() { # Returns 0 if the kiosk runs. READY=1 is sent after its first picture.
    [ "$(unit_property ActiveState)" = active ] && [ "$(unit_property MainPID)" != 0 ]
}

opened_ms() { # Prints the time from power on until the kiosk opened.
    echo $(($(unit_property ActiveEnterTimestampMonotonic) / 1000))
}

# A restarted kiosk writes another recording. The host must follow the new recording.
follow() {
    say "recording play-$(unit_property MainPID).kgr"
    rm -f $host/seen
    await 60 test -s $host/seen
}

read_count() { # NAME: Prints a value of the recording as the host computed it a moment ago (state_writer.c).
    sed -n "s/^$1 //p" $host/seen 2>/dev/null
}

reads() { # NAME OPERATOR NUMBER
    test "$(read_count "$1")" "$2" "$3" 2>/dev/null
}

# Copies the shaders for the next machine, all of them or none. Mesa 25 has them in the folder mesa_shader_cache_db, Mesa 22
# in mesa_shader_cache.
keep_shaders() {
    mkdir -p $host/out/mesa.new
    cp -r /var/cache/kingyo/mesa_shader_cache* $host/out/mesa.new/ 2>/dev/null && rm -rf $host/out/mesa &&
        mv $host/out/mesa.new $host/out/mesa
}
