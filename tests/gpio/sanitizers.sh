#!/bin/bash
# sanitizers.sh -- GPIO under the sanitizers: the reader's thread and the frame loop under thread, and these,
# a rain of coins and this machine's backend under address and undefined. Run by `make test-gpio-sanitizers`.
set -eu
home=${BUILD:-build}/gpio-sanitizers
read -ra cflags <<<"${CFLAGS:--std=c17 -O2 -I.}"
read -ra ldflags <<<"${LDFLAGS:-}"
cc=${CC:-gcc}
gpiod=${GPIOD:-0}
mkdir -p "$home"
drivers=(drivers/gpio/{buttons_gpio,gpio_signal,gpio_thread,gpio_config}.c
    drivers/sim/gpio_lines_sim.c tests/unit/support/panic.c)

try() { # NAME SANITIZERS SOURCES...
    local name=$1 sanitizers=$2
    shift 2
    local program=$home/$name-${sanitizers%%,*}
    $cc "${cflags[@]}" -fsanitize="$sanitizers" -fno-sanitize-recover=all -o "$program" "$@" -lcmocka -lpthread
    CMOCKA_MESSAGE_OUTPUT=TAP "$program" >"$program.log" 2>&1 || { cat "$program.log" >&2; exit 1; }
    echo "  ok    $name under $sanitizers: $(grep -c '^ok' "$program.log") tests"
}

try test_buttons_gpio thread tests/unit/drivers/gpio/test_buttons_gpio.c "${drivers[@]}"
try test_buttons_gpio address,undefined tests/unit/drivers/gpio/test_buttons_gpio.c "${drivers[@]}"
try test_gpio_thread address,undefined tests/unit/drivers/gpio/test_gpio_thread.c "${drivers[@]}"
try test_coin_rain address,undefined tests/unit/drivers/gpio/test_coin_rain.c tests/gpio/coin_rain.c "${drivers[@]}"
if [ "$gpiod" != 0 ]; then
    try test_gpio_backend address,undefined "${ldflags[@]}" tests/gpio/{test_gpio_backend,fake_board,"fake_gpiod$gpiod"}.c \
        drivers/gpio/{"gpio_lines$gpiod",gpio_backend,gpio_dev,gpio_config}.c tests/unit/support/panic.c
fi
