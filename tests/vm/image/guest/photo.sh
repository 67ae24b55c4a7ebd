# photo.sh -- waits before the data partition is opened, so that the host can take a snapshot of
# the machine. A machine that starts from the snapshot has another disk, so the cached data of that
# partition (its label, for udev) is dropped first.
# The screen is disconnected. The script runs from /run, because the folder shared with the host
# must not be in use during the snapshot.
# shellcheck shell=dash
udevadm settle --timeout=60
for socket in /sys/class/drm/card*-*/status; do
    echo off >"$socket"
done
# Reads the files of the kiosk into memory, because squashfs unpacks slowly on an emulated machine.
ldd /usr/bin/kingyo | awk '$3 ~ "^/" { print $3 }' | xargs cat /usr/bin/kingyo >/dev/null
umount /run/host || echo 'kingyo-test: the shared folder is in use' >/dev/ttyS0
exec 3</dev/ttyS1
echo 'kingyo-test: photo' >/dev/ttyS0
read -r _ <&3
mount -t 9p -o trans=virtio,version=9p2000.L,msize=524288 host /run/host
blockdev --flushbufs /dev/disk/by-partlabel/kingyo-data
