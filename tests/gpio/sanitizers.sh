#!/bin/bash
# sanitizers.sh -- GPIO tests under the sanitizers. The reader's thread and the frame loop run
# under the thread sanitizer. Both, a test with many coins and this machine's backend run under the
# address and undefined-behaviour sanitizers. Run by `make test-gpio-sanitizers`.
set -eu
home=${BUILD:-build}/gpio-sanitizers
read -ra cflags <<<"${CFLAGS:--std=c17 -O2 -I.}"
read -ra ldflags <<<"${LDFLAGS:-}"
cc=${CC:-gcc}
gpiod=${GPIOD:-0}
mkdir -p "$home"
drivers=(drivers/gpio/{gpio_device,gpio_signal,gpio_thread,gpio_config}.c
    drivers/sim/gpio_lines_sim.c platform/os/{file,log,panic,thread}.c core/base/printable.c
    tests/unit/support/panic.c)

try() { # NAME SANITIZERS SOURCES...
    local name=$1 sanitizers=$2
    shift 2
    local program=$home/$name-${sanitizers%%,*}
    $cc "${cflags[@]}" -fsanitize="$sanitizers" -fno-sanitize-recover=all -o "$program" "$@" -lcmocka -lpthread
    CMOCKA_MESSAGE_OUTPUT=TAP "$program" >"$program.log" 2>&1 || { cat "$program.log" >&2; exit 1; }
    echo "  ok    $name under $sanitizers: $(grep -c '^ok' "$program.log") tests"
}

try test_gpio_device thread tests/unit/drivers/gpio/test_gpio_device.c "${drivers[@]}"
try test_gpio_device address,undefined tests/unit/drivers/gpio/test_gpio_device.c "${drivers[@]}"
for name in test_gpio_thread test_gpio_coins test_gpio_outputs; do
    try $name address,undefined tests/unit/drivers/gpio/$name.c "${drivers[@]}"
done
try test_coin_rain address,undefined tests/unit/drivers/gpio/test_coin_rain.c tests/gpio/coin_rain.c "${drivers[@]}"
if [ "$gpiod" != 0 ]; then
    try test_gpio_backend address,undefined "${ldflags[@]}" tests/gpio/{test_gpio_backend,fake_board,"fake_gpiod$gpiod"}.c \
        drivers/gpio/{"gpio_lines$gpiod",gpio_backend,gpio_dev,gpio_config}.c tests/unit/support/panic.c
fi
