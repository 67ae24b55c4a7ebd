# cabinet.sh -- simulated wiring of a cabinet: a gpio-sim chip with named lines, which are pressed
# through its pull files.
# Buttons and the coin mechanism pull their line low, as real devices do. Coins are accepted while
# the coil of the lockout has current, so a low line locks the coin slot.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # init sources all files of this folder
cabinet=/sys/kernel/config/gpio-sim/cabinet
cabinet_lines='START COIN TEST SERVICE TILT DOOR LAMP LOCKOUT METER TICKET'
cabinet_wiring='start=START coin=COIN test=TEST service=SERVICE tilt=TILT door=DOOR
    start-lamp=LAMP coin-lockout=LOCKOUT coin-counter=METER ticket=TICKET'
coin_window='15 250' # Duration of a coin's pulse in ms, if no other range is configured.

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

wire() { # NAME: Prints the folder of the line.
    number=0
    for name in $cabinet_lines; do
        [ "$name" = "$1" ] && echo "/run/cabinet/sim_gpio$number"
        number=$((number + 1))
    done
}

press() { # NAME: Presses the button for 0.15 s.
    panel pulse "$(wire "$1")" 150 150 1 >/dev/null
}

coins() { # COUNT: Sends a pulse of 60 ms for each coin, with a gap of 60 ms.
    panel pulse "$(wire COIN)" 60 60 "$1" $coin_window
}

# Returns 0 if the kiosk holds the line.
is_held() { # NAME
    gpioinfo | grep -q "\"$1\".*kingyo"
}

is_lit() { # NAME: Returns 0 if the kiosk outputs 1 on the line.
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

# Before the kiosk opens the lines: sends a coin, a pulse that is too short and a pulse that is too
# long. Returns 1 if the command did not distinguish the pulses, or 2 if this machine was delayed
# and sent other pulses.
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
    for row in 'coin 1, its pulse' 'pulses too short for a coin: 1' 'coins stuck in the slot: 1'; do
        grep -q "coin.$row" $host/out/lines || return 1
    done
    ! grep -qE 'coin 2|: 2 so far|lost|glitches|cut off' $host/out/lines
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
