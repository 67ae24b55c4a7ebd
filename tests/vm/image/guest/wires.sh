# wires.sh -- prepares the machine before the kiosk opens: its lines, our poi on a cable, and
# shaders of an earlier machine.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # the sourced files set these variables
. /run/host/guest/common.sh
if [ -d $host/mesa ]; then
    mkdir -p /var/cache/kingyo
    cp -r $host/mesa/. /var/cache/kingyo/
    chown -R kingyo:kingyo /var/cache/kingyo
fi
mount -t configfs config /sys/kernel/config 2>/dev/null
cabinet_open
poi_plug_in
