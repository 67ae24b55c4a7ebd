# cabinet.sh -- a cabinet's wires: a gpio-sim chip with named lines, pressed from its pull files.
#
# Buttons and the coin mechanism pull their line low, as real ones do. Coins come in while the lock's
# coil has current, so it locks when its line is low.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # init sources all of them
cabinet=/sys/kernel/config/gpio-sim/cabinet
cabinet_lines='START COIN TEST SERVICE TILT DOOR LAMP LOCKOUT METER TICKET'
cabinet_wiring='start=START coin=COIN test=TEST service=SERVICE tilt=TILT door=DOOR
    start-lamp=LAMP coin-lockout=LOCKOUT coin-counter=METER ticket=TICKET'
coin_window='15 250' # ms: what a coin's pulse lasts where nothing else is wired.

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
    ln -sfn "/sys/devices/platform/$(cat $cabinet/dev_name)/$(cat $cabinet/bank/chip_name)" /run/cabinet
}

cabinet_pull_out() {
    echo 0 >$cabinet/live
}

wire() { # NAME: the folder of its line
    number=0
    for name in $cabinet_lines; do
        [ "$name" = "$1" ] && echo "/run/cabinet/sim_gpio$number"
        number=$((number + 1))
    done
}

press() { # NAME: down for 0.15 s
    panel pulse "$(wire "$1")" 150 150 1 >/dev/null
}

coins() { # COUNT: each a pulse of 60 ms, with as much between
    panel pulse "$(wire COIN)" 60 60 "$1" $coin_window
}

# Whether the kiosk has the line in its hand.
is_held() { # NAME
    gpioinfo | grep -q "\"$1\".*kingyo"
}

is_lit() { # NAME: whether the kiosk puts out 1 there
    [ "$(cat "$(wire "$1")/value")" = 1 ]
}

is_dark() { # NAME
    ! is_lit "$1"
}

meter_begin() {
    panel count "$(wire METER)" /run/meter &
    meter=$!
    await 5 test -e /run/meter
}

has_metered() { # COUNT
    [ "$(cat /run/meter)" -eq "$1" ]
}

# Before the kiosk has the lines: a coin, a pulse too short for one, and one that sticks. 1: they were
# not told apart; 2: this machine stood still, and the pulses were others.
jam_once() {
    as kingyo kingyoctl lines watch coin=COIN --seconds 8 >$host/out/lines 2>&1 &
    watch=$!
    await 5 is_held COIN
    sleep 0.5
    coins 1 >$host/out/pulses
    panel pulse "$(wire COIN)" 5 300 1 3 14 >>$host/out/pulses
    panel pulse "$(wire COIN)" 400 300 1 251 5000 >>$host/out/pulses
    wait $watch
    [ "$(grep -c ' 0 shorter, 0 longer' $host/out/pulses)" -eq 3 ] || return 2
    for row in 'coin 1, its pulse' 'too short for a coin: 1' 'a coin sticks: 1'; do
        grep -q "coin.$row" $host/out/lines || return 1
    done
    ! grep -qE 'coin 2|: 2 so far|lost|sparks|mid-pulse' $host/out/lines
}

jam() {
    tries=0 status=2
    while [ $status -eq 2 ] && [ $tries -lt 4 ]; do
        tries=$((tries + 1))
        jam_once
        status=$?
    done
    found $status jams "$(grep -h 'coin' $host/out/lines | cut -f 3 | tr '\n' ';') try $tries"
}
