#!/bin/bash
# gallery.sh BUILD FOLDER -- draws each scene of gallery.txt to FOLDER/NAME.png, with the quality for a Raspberry Pi 4.
# Mesa's llvmpipe draws, as for the golden pictures. GPU="" draws with the quality for this machine, and QUALITY_STEP=N lowers the quality by N steps.
set -eu
here=$(dirname "$0")
mkdir -p "$2"
while read -r name options; do
    [[ $name == \#* || -z $name ]] && continue
    # shellcheck disable=SC2086
    env LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe LD_PRELOAD="$(realpath "$1")/tests/v3d/gl_trace.so" ${GPU-GL_TRACE_RENDERER=V3D} \
        "$1/tests/render/shot" $options --quality-step "${QUALITY_STEP:-0}" -o "$2/$name.png" >/dev/null 2>"$2/$name.log" ||
        { grep -v '^PROGRAM\|^DRAW' "$2/$name.log" >&2; exit 1; }
    rm -f "$2/$name.log"
done <"$here/gallery.txt"
echo "$2"
