# stall.sh -- the test of the disk image in the guest: power on, a round, SIGKILL, a hang, foreign
# devices, power off.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091,SC1090  # the sourced files set these variables
. /run/host/guest/common.sh

# Prints the time in ms from WHEN_MS until the kiosk is open after a restart, or 0 if it does not
# open.
opens_again() { # STARTS WHEN_MS SECONDS
    await "$3" restarted "$1" && await "$3" is_open && echo $(($(opened_ms) - $2)) || echo 0
}

restarted() { # STARTS: Returns 0 if the unit was restarted more often than STARTS.
    [ "$(unit_property NRestarts)" -gt "$1" ]
}

writable() { # Prints the writable mount points of the disk.
    awk '$4 ~ /^rw/ && $1 ~ "^/dev/" { printf "%s ", $2 }' /proc/mounts
}

refuses_writes() { # Root cannot write either, even after a remount.
    mount -o remount,rw / 2>/dev/null
    for folder in / /etc /usr/bin /var/lib /root /home /opt /boot; do
        ! touch "$folder/mark" 2>/dev/null || return 1
    done
}

part() { # NAME
    say "part $1"
    . "$host/guest/$1.sh"
}

say "booted $(uname -rm), systemd $(systemctl --version | sed -n '1s/systemd \([0-9]*\).*/\1/p')"
await 2400 is_open
found $? opens "$(opened_ms) ms after power on, of which systemd took $(($(unit_property InactiveExitTimestampMonotonic) / 1000)) to start it"
follow
shot attract
keep_shaders
refuses_writes && [ "$(writable)" = '/var/lib/kingyo ' ]
found $? readonly "writable mount points of the disk: $(writable)"
await 20 grep -q '^kept' /run/kingyo-data
found $? data "$(cat /run/kingyo-data)"
systemd-analyze security --no-pager kingyo.service >$host/out/security 2>&1
exposure=$(sed -n 's/.*Overall exposure level for kingyo.service: \([0-9.]*\).*/\1/p' $host/out/security)
[ -n "$exposure" ] && awk "BEGIN { exit !($exposure <= 1.5) }"
found $? exposure "$exposure"
is_kingyo "$(unit_property MainPID)"
found $? user "kingyo, in $(groups_of "$(unit_property MainPID)")"
poi_hold
for name in $(cat $host/parts); do
    part "$name"
done
journalctl -b --no-pager -o short-monotonic >$host/out/journal
dmesg >$host/out/dmesg
keep_shaders
say 'end'
systemctl poweroff
