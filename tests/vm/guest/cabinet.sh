# cabinet.sh -- a cabinet's wires: a gpio-sim chip with named lines, pressed from its pull files.
#
# Buttons and the coin mechanism pull their line low, as real ones do.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # init sources all of them
cabinet=/sys/kernel/config/gpio-sim/cabinet
cabinet_lines='START COIN TEST SERVICE TILT DOOR LAMP LOCKOUT METER TICKET'

cabinet_open() {
    modprobe gpio-sim
    mkdir -p $cabinet/bank
    echo 10 >$cabinet/bank/num_lines
    echo cabinet >$cabinet/bank/label
    number=0
    for name in $cabinet_lines; do
        mkdir -p $cabinet/bank/line$number
        echo "$name" >$cabinet/bank/line$number/name
        number=$((number + 1))
    done
    cabinet_plug
}

cabinet_plug() {
    echo 1 >$cabinet/live
    chip=/sys/devices/platform/$(cat $cabinet/dev_name)/$(cat $cabinet/bank/chip_name)
}

cabinet_pull_out() {
    echo 0 >$cabinet/live
}

wire() { # NAME: the folder of its line
    number=0
    for name in $cabinet_lines; do
        [ "$name" = "$1" ] && echo "$chip/sim_gpio$number"
        number=$((number + 1))
    done
}

press() { # NAME: down for 0.15 s
    wire=$(wire "$1")
    echo pull-down >"$wire/pull"
    sleep 0.15
    echo pull-up >"$wire/pull"
    sleep 0.15
}

coins() { # COUNT: each a pulse of 40 to 70 ms, with as much between
    wire=$(wire COIN)
    left=$1
    while [ "$left" -gt 0 ]; do
        echo pull-down >"$wire/pull"
        sleep 0.0$((4 + left % 3))
        echo pull-up >"$wire/pull"
        sleep 0.0$((4 + left % 2))
        left=$((left - 1))
    done
}

# Whether the kiosk has the line in its hand.
is_held() { # NAME
    gpioinfo | grep -q "\"$1\".*kingyo"
}

lamp() { # NAME: what the kiosk puts out there, 0 or 1
    cat "$(wire "$1")/value"
}
