# pi.sh -- the test of the card in QEMU's `raspi3b`: the parts of the board, the data partition, the kiosk's status.
# Each line "kt ok ID words" or "kt bad ID words" on the console is a result (raspi3b.sh).
# shellcheck shell=dash
export PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8
status=/run/kingyo/status.json

say() { echo "kt $*"; }

found() { # STATUS ID WORDS
    if [ "$1" -eq 0 ]; then say "ok $2 ${3-}"; else say "bad $2 ${3-}"; fi
}

up() { cut -d. -f1 /proc/uptime; }

await() { # SECONDS COMMAND...
    end=$(($(up) + $1))
    shift
    until "$@" >/dev/null 2>&1; do
        [ "$(up)" -lt "$end" ] || return 1
        sleep 1
    done
}

refuses_writes() {
    mount -o remount,rw / 2>/dev/null
    for folder in / /etc /usr/bin /var/lib /root /opt; do
        ! touch "$folder/mark" 2>/dev/null || return 1
    done
}

names_match() { # The header's lines have the names of the cabinet's pins.
    for name in OK TEST START_LAMP SERVICE COIN_LOCKOUT START TILT TICKET COIN_COUNTER RIGHT COIN COIN2 COIN3 DOOR LEFT; do
        echo "$lines" | grep -qw "$name" || return 1
    done
}

phase() { sed -n 's/.*"phase": *"\([^"]*\)".*/\1/p' $status; }

shows_attract() { [ "$(phase)" = attract ]; }

property() { systemctl show -P "$2" "$1"; }

# Prints the state of the kiosk each minute, because its first picture takes many minutes in this emulator.
watch_kiosk() {
    while sleep 60; do
        say "kiosk $(property kingyo.service ActiveState), $(($(property kingyo.service CPUUsageNSec) / 1000000000)) s of processor time, $(up) s after power on"
    done
}

echo # systemd has written to this console without an end of line.
say "booted $(tr -d '\0' </proc/device-tree/model), $(uname -r), $(up) s after power on"
card=$(readlink -f "$(findmnt -no SOURCE /)") # A name in /dev/kingyo is a link.
[ "$card" = /dev/mmcblk0p6 ] && [ "$(findmnt -no FSTYPE /)" = squashfs ]
found $? sd "root $card on $(cat /sys/block/mmcblk0/device/name 2>/dev/null), $(($(cat /sys/block/mmcblk0/size) / 2048)) MiB"
refuses_writes
found $? readonly "$(findmnt -no OPTIONS / | cut -c 1-30)"
await 900 grep -q . /run/kingyo-data
grep -q '^kept' /run/kingyo-data
found $? data "$(cat /run/kingyo-data)"
size=$(df -m /var/lib/kingyo | awk 'NR == 2 { print $2 }')
await 300 test "$(property kingyo-grow.service ActiveState)" = active
size=$(df -m /var/lib/kingyo | awk 'NR == 2 { print $2 }')
[ "$size" -gt 1000 ]
found $? grow "the data partition has $size MiB on a card of 2048 MiB"
identity=$(cat /sys/class/watchdog/watchdog0/identity)
[ "$identity" = 'Broadcom BCM2835 Watchdog timer' ]
found $? watchdog "$identity, limit $(cat /sys/class/watchdog/watchdog0/timeout) s, not started here"
lines=$(kingyoctl lines list)
names_match
found $? names "$(echo "$lines" | grep -cw 'START\|COIN\|DOOR\|TILT') of 4 lines on $(echo "$lines" | grep -w START)"
watch_kiosk &
watcher=$!
await 3000 shows_attract
found $? status "phase $(phase), $(up) s after power on"
kill $watcher
say 'shot tank tank'
sleep 120 # The host takes pictures until one shows the tank, because a frame takes seconds.
failed=$(systemctl --failed --no-legend --plain | cut -d' ' -f1 | tr '\n' ' ')
[ -z "$failed" ]
found $? units "failed units: ${failed:-none}"
systemctl list-units --no-legend --plain 'kingyo*' | sed 's/^/kt unit /'
journalctl -b --no-pager -o cat -u kingyo.service | head -20 | sed 's/^/kt log /'
journalctl -b -p warning --no-pager -o short-monotonic | head -60 | sed 's/^/kt warning /'
say end
