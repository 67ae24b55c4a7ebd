# wires.sh -- before the stall opens: what it kept until now is shown outside; then its lines, and our poi on a cable.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # it sources what it uses
. /run/host/guest/common.sh
mkdir -p $host/out/kept
cp /var/lib/kingyo/kingyo.db* $host/out/kept/ 2>/dev/null
cat /run/kingyo-data >$host/out/kept/data 2>/dev/null
if [ -d $host/mesa ]; then
    mkdir -p /var/cache/kingyo
    cp -r $host/mesa /var/cache/kingyo/mesa_shader_cache
    chown -R kingyo:kingyo /var/cache/kingyo
fi
mount -t configfs config /sys/kernel/config 2>/dev/null
cabinet_open
poi_plug_in
