# update.sh -- the update page with real USB sticks, which the host plugs in and out: each fault, a stick that is pulled out
# while the update is written, and a good update.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # the sourced files set these variables
. /run/host/guest/common.sh
status=/run/kingyo-update/status

stick() { # NAME or none: the host exchanges the stick.
    rm -f $host/stick-done
    say "stick $1"
    await 120 test -e $host/stick-done
}

shows() { # BEGINNING of the service's line
    case $(cat $status 2>/dev/null) in "$1"*) ;; *) return 1 ;; esac
}

line() { cat $status 2>/dev/null; }

idle_sum() { # The state of the slots, and the beginning of the idle slot.
    cat /dev/kingyo/slots | sha256sum
    head -c 16777216 /dev/kingyo/root-idle | sha256sum
}

pushes() { # NAME COUNT
    local left=$2
    while [ "$left" -gt 0 ]; do
        press "$1"
        sleep 0.4
        left=$((left - 1))
    done
}

open_page() {
    pushes TEST 1
    pushes SERVICE 7
    pushes TEST 1 # Upkeep
    pushes SERVICE 5
    pushes TEST 1 # Update
    await 60 test -e /run/kingyo/update-open
}

close_page() { # TEST on Back leads to the page of upkeep, where TEST opens the page again.
    pushes TEST 1
    await 60 shows closed
}

no_driver() {
    ! grep -qE '^(usb_storage|uas|sd_mod|vfat|exfat) ' /proc/modules && ! ls -d /sys/block/sd* >/dev/null 2>&1
}

fails_with() { # STICK FAULT
    local before after
    before=$(idle_sum)
    stick "$1"
    await 90 shows "failed 0 $2"
    local code=$?
    after=$(idle_sum)
    found $code "$1" "$(line)"
    [ "$before" = "$after" ] || found 1 untouched "$1 changed the disk"
    stick none
    await 60 shows no-stick || found 1 "$1" "still $(line)"
}

case $(cat $host/pass) in exits | no-frames) exit 0 ;; esac # The kiosk of these systems does not open.
await 900 is_open
found $? opens "$(opened_ms) ms after power on, slot $(cat /run/kingyo-slot)"
await 60 is_held TEST
case $(cat $host/pass) in fell-back | returned) # The start after two starts of a system that does not run.
    sleep 2
    open_page
    await 60 shows 'no-stick 0 fell-back'
    found $? "$(cat $host/pass)" "$(line); slot $(cat /run/kingyo-slot)"
    close_page
    say end
    systemctl poweroff
    exit 0
    ;;
esac
if [ "$(cat $host/pass)" = good ]; then # The start of a new system that runs.
    . /usr/lib/kingyo/slots.sh
    slots_read /dev/kingyo/slots && [ "$good$trial$starts" = ab1 ]
    found $? trial "slot $(cat /run/kingyo-slot): good $good, trial $trial, starts left $starts"
    is_marked() { slots_read /dev/kingyo/slots && [ "$good$trial" = b- ]; }
    await 120 is_marked
    marked=$?
    journalctl -b --no-pager -o short-monotonic >$host/out/journal
    found $marked marked "$(systemctl show -P ActiveState kingyo-slot-good.service), slot $(cat /run/kingyo-slot)"
    say end
    systemctl poweroff
    exit 0
fi
coins 4 >/dev/null
if [ "$(cat $host/pass)" = coins ]; then # Another part of the test plugs in sticks.
    sleep 10 # After this time the coins are saved.
    say end
    systemctl poweroff
    exit 0
fi
stick good
sleep 5
no_driver
found $? closed "block devices with a stick and a closed page: $(ls /sys/block | tr '\n' ' ')"
stick none
open_page
await 60 shows no-stick
found $? no-stick "$(line)"
for row in $(cat $host/faults); do
    fails_with "${row%:*}" "${row#*:}"
done
before=$(idle_sum) # The chunks are checked after the operator has started the update.
stick damaged
await 90 shows found && pushes SERVICE 1 && pushes TEST 1
await 120 shows 'failed 0 damaged'
found $? damaged "$(line)"
[ "$(idle_sum)" = "$before" ] || found 1 untouched 'damaged changed the disk'
stick none
await 60 shows no-stick
found 0 untouched 'no fault changed the state or the idle slot'

stick good
await 90 shows found
found $? found "$(line)"
systemctl show -P MainPID kingyo-update.service >/run/pid
nsenter -m -t "$(cat /run/pid)" cat /proc/mounts | grep /stick >$host/out/mounts
grep -q 'ro,nosuid,nodev,noexec' $host/out/mounts && ! grep -q kingyo-update/stick /proc/mounts
found $? mount "$(cut -d' ' -f1,3,4 $host/out/mounts)"
systemd-analyze security --no-pager kingyo-update.service >$host/out/security-update 2>&1
pushes SERVICE 1
pushes TEST 1
await 120 shows writing
stick none
await 90 shows 'failed 0 pulled'
found $? pulled "$(line)"
stick good
await 90 shows found
pushes SERVICE 1
pushes TEST 1
await 300 shows 'done'
found $? written "$(line)"
journalctl -b --no-pager -o short-monotonic >$host/out/journal
close_page
await 60 no_driver
found $? unloaded "block devices after the page: $(ls /sys/block | tr '\n' ' ')"
pushes TEST 1 # The same stick may be written again, because the new system has not started yet.
await 90 shows found
pushes SERVICE 1
pushes TEST 1
await 300 shows 'done'
say end
stick none # The service restarts the machine.
