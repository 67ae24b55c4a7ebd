#!/bin/bash
# build.sh FOLDER -- builds what `make bench-v3d` measures with, all inside FOLDER/root, a root file system of Debian 13:
# Mesa's drivers v3d and softpipe from Debian's source package with mesa.patch, and Kingyo's tests/render/shot.
# Needs root, mmdebstrap and a mirror. Mesa takes about a quarter of an hour of two processors. A finished build is kept:
# Mesa is built again only after mesa.patch changed, and shot by make as usual.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
root=$folder/root
. "$here/inside.sh"
if [ "$(id -u)" -ne 0 ] || ! command -v mmdebstrap >/dev/null; then
    echo 'bench-v3d: needs root and mmdebstrap; run: sudo apt-get install mmdebstrap; sudo make bench-v3d' >&2
    exit 1
fi

if [ ! -e "$folder/root.made" ]; then
    echo 'bench-v3d: making a root of Debian 13 ...'
    rm -rf --one-file-system "$root"
    sources=$("$here/../../board/debian_sources.sh" trixie bench-v3d)
    mapfile -t sources <<<"$sources"
    mmdebstrap --quiet --mode=root --variant=minbase --include="$(tr '\n' ',' <"$here/packages.txt")" \
        trixie "$root" "${sources[@]}" "${sources[@]/#deb /deb-src }"
    touch "$folder/root.made"
fi

if ! cmp -s "$here/mesa.patch" "$folder/mesa.made"; then
    echo "bench-v3d: building Mesa (a quarter of an hour; log in $folder/mesa.log) ..."
    cp /etc/resolv.conf "$root/etc/" 2>/dev/null || true
    inside sh -euc '
        mkdir -p /mesa && cd /mesa
        apt-get -qq update && apt-get -qq source --download-only mesa
        rm -rf source && mkdir source && tar xf mesa_*.orig.tar.xz -C source --strip-components=1
        cd source && patch --quiet -p1 </kingyo/tests/v3d/mesa.patch
        meson setup /mesa/build . -Dgallium-drivers=v3d,softpipe -Dvulkan-drivers= -Dtools=drm-shim -Dplatforms= \
            -Dgbm=enabled -Degl=enabled -Dgles1=disabled -Dgles2=enabled -Dglx=disabled -Dglvnd=disabled \
            -Dllvm=disabled -Dvideo-codecs= -Dshader-cache=disabled -Dxmlconfig=disabled -Dvalgrind=disabled \
            -Dlibunwind=disabled -Dzstd=disabled -Dbuildtype=release -Doptimization=1
        ninja -C /mesa/build' >"$folder/mesa.log" 2>&1 || { tail -20 "$folder/mesa.log" >&2; exit 1; }
    cp "$here/mesa.patch" "$folder/mesa.made"
fi

inside bash /kingyo/board/setup.sh run >"$folder/kingyo.log" 2>&1
inside make -C /kingyo --no-print-directory -j"$(nproc)" BUILD="build/v3d/kingyo" build/v3d/kingyo/tests/{render/shot,v3d/gl_trace.so} \
    >>"$folder/kingyo.log" 2>&1 || { tail -20 "$folder/kingyo.log" >&2; exit 1; }
