#!/bin/bash
# builder.sh -- a root of the guest's release for compiling, in $cache/builder: gcc, make and the
# libraries.
# The root compiles kernel modules. If the guest has another release or architecture than this
# machine, it also compiles the kiosk. Its programs have the architecture of this machine, its
# libraries that of the guest.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"

builder=$cache/builder
is_fresh "$builder/made" && exit 0
step "a root to build in: $suite"
tools=base-files,base-passwd,dash,bash,coreutils,sed,grep,gawk,findutils,tar,diffutils,gcc,libc6-dev,make,pkg-config,bc
kbuild=$(guest_apt apt-cache depends "linux-headers-$(kernel_release)" |
    sed -n 's/.*Depends: \(linux-kbuild-[^ :]*\).*/\1/p' | head -1)
tools+=,$kbuild,fonts-morisawa-bizud-gothic,fonts-kouzan-mouhitsu,fonts-open-sans,fonts-reggae,libstb-dev
libraries=libsdl2-dev,libgles-dev,libegl-dev,libsqlite3-dev,libusb-1.0-0-dev,libgpiod-dev
architectures=amd64
if [ "$arch" != amd64 ]; then
    architectures=amd64,$arch
    tools+=,gcc-${tuple//_/-},libc6-dev:$arch,libstb-dev:$arch
    libraries=$(sed "s/,/:$arch,/g; s/\$/:$arch/" <<<"$libraries")
fi
unpack_root "$builder" "$architectures" "$tools,$libraries"
settle_root "$builder"
ln -sfn gawk "$builder/usr/bin/awk"
# An archive of objects for another architecture needs the ar of that architecture.
if [ -n "$cross" ]; then
    mkdir -p "$builder/usr/local/bin"
    ln -sf "/usr/bin/${cross}ar" "$builder/usr/local/bin/ar"
fi
touch "$builder/made"
