#!/bin/bash
# gpiod2.sh -- tests drivers/gpio/gpio_lines2.c with Debian 13's libgpiod on a machine with another
# version. The script fetches the header and the library into BUILD/gpiod2 once, compiles the file,
# checks that the library has every required function, and runs the backend's test with the fake
# library. Run by `make gpiod2`.
set -eu
home=${BUILD:-build}/gpiod2
read -ra cflags <<<"${CFLAGS:--std=c17 -O2 -I.}"
read -ra ldflags <<<"${LDFLAGS:-}"
cc=${CC:-gcc}

fetch() {
    local root sources
    root=$(mktemp -d)
    mapfile -t sources < <(board/debian_sources.sh trixie gpiod2)
    if ! mmdebstrap --quiet --variant=extract --include=libgpiod-dev trixie "$root" "${sources[@]}" 2>"$home/fetch.log"; then
        echo "gpiod2: Debian 13's libgpiod could not be fetched: see $home/fetch.log" >&2
        rm -rf "$root"
        exit 74
    fi
    cp "$root"/usr/include/gpiod.h "$home/"
    cp "$root"/usr/lib/*/libgpiod.so.3 "$root"/usr/lib/*/pkgconfig/libgpiod.pc "$home/"
    rm -rf "$root"
}

mkdir -p "$home"
[ -e "$home/libgpiod.pc" ] || fetch
version=$(sed -n 's/^Version: //p' "$home/libgpiod.pc")
$cc "${cflags[@]}" -isystem "$home" -c -o "$home/gpio_lines2.o" drivers/gpio/gpio_lines2.c
missing=$(comm -23 <(nm -u "$home/gpio_lines2.o" | awk '/gpiod_/ { print $2 }' | sort -u) \
    <(nm -D --defined-only "$home/libgpiod.so.3" | awk '{ sub("@.*", "", $3); print $3 }' | sort))
if [ -n "$missing" ]; then
    echo "gpiod2: libgpiod $version has no" $missing >&2
    exit 1
fi
$cc "${cflags[@]}" -isystem "$home" "${ldflags[@]}" -fsanitize=address,undefined -o "$home/test_gpio_backend" \
    tests/gpio/{test_gpio_backend,fake_board,fake_gpiod2}.c tests/unit/support/panic.c \
    drivers/gpio/{gpio_lines2,gpio_backend,gpio_dev,gpio_config}.c -lcmocka
CMOCKA_MESSAGE_OUTPUT=TAP "$home/test_gpio_backend" >"$home/test.log" 2>&1 || { cat "$home/test.log" >&2; exit 1; }
echo "gpiod2: gpio_lines2.c compiles with libgpiod $version, which has every required function; $(grep -c '^ok' "$home/test.log") tests passed"
