#!/bin/bash
# programs.sh -- builds the kiosk and its helper programs for the guest, and prints their folder.
# If this machine has the guest's release and architecture, the script uses the result of `make`.
# Otherwise the compiler of the builder (builder.sh) compiles all programs against the guest's
# libraries.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"
release=$(. /etc/os-release && echo "${VERSION_CODENAME-}")

if [ "$release/$(dpkg --print-architecture)" = "$suite/$arch" ]; then
    make -s -C "$top" BUILD="$BUILD" vm-guest >&2
    (cd "$top" && cd "$BUILD" && pwd)
    exit 0
fi
step "the kiosk for $suite, $arch" >&2
builder=$cache/builder
mkdir -p "$builder/src"
(cd "$top" && git ls-files -co --exclude-standard -z | tar --null -cT -) | tar -x -C "$builder/src"
chroot "$builder" env PATH=/usr/local/bin:/usr/bin PKG_CONFIG_LIBDIR="/usr/lib/$tuple/pkgconfig:/usr/share/pkgconfig" \
    make -s -j"$(nproc)" -C /src CC="${cross}gcc" BUILD_CC=gcc BUILD=build \
    vm-guest >"$cache/programs.log" 2>&1 || {
    tail -20 "$cache/programs.log" >&2
    exit 1
}
echo "$builder/src/build"
