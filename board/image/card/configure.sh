#!/bin/bash
# configure.sh ROOT -- does the work of the packages' own scripts in a root whose processor is not that of this machine.
#
# Debian's scripts would run under emulation, where each start of perl takes seconds. The image needs only a few of their
# results: users, the cache of the libraries, and links. The database of udev (hwdb), which has names and odd keyboards, is
# left out.
set -eu
root=${1:?usage: configure.sh ROOT}

# The users and groups that each Debian system has (base-passwd), and those of the services.
for file in passwd group; do
    [ -s "$root/etc/$file" ] || cp "$root/usr/share/base-passwd/$file.master" "$root/etc/$file"
done
[ -s "$root/etc/shadow" ] || sed 's/^\([^:]*\):.*/\1:*:1::::::/' "$root/etc/passwd" >"$root/etc/shadow"
[ -s "$root/etc/gshadow" ] || sed 's/^\([^:]*\):.*/\1:*::/' "$root/etc/group" >"$root/etc/gshadow"
chmod 640 "$root/etc/shadow" "$root/etc/gshadow"
chroot "$root" /usr/bin/systemd-sysusers
chroot "$root" /usr/sbin/ldconfig
rm -rf "$root/usr/lib/udev/hwdb.d"
[ -e "$root/usr/bin/awk" ] || ln -s mawk "$root/usr/bin/awk"
[ -e "$root/etc/nsswitch.conf" ] || printf 'passwd: files\ngroup: files\nshadow: files\nhosts: files\n' >"$root/etc/nsswitch.conf"
echo '127.0.0.1 localhost' >"$root/etc/hosts"
