#!/bin/bash
# programs.sh -- the kiosk and its helpers for the guest; prints the folder they lie in.
#
# Where this machine is of the guest's release and architecture, what `make` built for it is taken as it
# is. Else all is compiled in the builder (builder.sh), by its own compiler against the guest's libraries.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
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
