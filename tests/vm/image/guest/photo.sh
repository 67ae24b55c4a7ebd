# photo.sh -- a machine that is about to look at its data partition waits here; whoever begins from this moment again has
# another disk in it. What the kernel had read of that partition (its label, for udev) is forgotten first.
#
# Its screen is pulled out meanwhile. This runs from /run: while the picture of the machine is taken nothing may be open in
# the folder shared with it.
# shellcheck shell=dash
udevadm settle --timeout=60
for socket in /sys/class/drm/card*-*/status; do
    echo off >"$socket"
done
# What the stall runs of is in memory already: squashfs unpacks slowly in software.
ldd /usr/bin/kingyo | awk '$3 ~ "^/" { print $3 }' | xargs cat /usr/bin/kingyo >/dev/null
umount /run/host || echo 'kingyo-test: the shared folder is in use' >/dev/ttyS0
exec 3</dev/ttyS1
echo 'kingyo-test: photo' >/dev/ttyS0
read -r _ <&3
mount -t 9p -o trans=virtio,version=9p2000.L,msize=524288 host /run/host
blockdev --flushbufs /dev/disk/by-partlabel/kingyo-data
