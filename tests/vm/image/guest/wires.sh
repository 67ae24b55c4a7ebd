# wires.sh -- before the stall opens: its lines, our poi on a cable, and shaders that a machine before this one compiled.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # it sources what it uses
. /run/host/guest/common.sh
if [ -d $host/mesa ]; then
    mkdir -p /var/cache/kingyo
    cp -r $host/mesa /var/cache/kingyo/mesa_shader_cache
    chown -R kingyo:kingyo /var/cache/kingyo
fi
mount -t configfs config /sys/kernel/config 2>/dev/null
cabinet_open
poi_plug_in
