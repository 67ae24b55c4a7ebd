# play.sh -- the main test: coins, START, a fish by the USB poi, cables that are unplugged and
# replugged, SIGTERM.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # init sources all files of this folder
. $host/guest/cabinet.sh
. $host/guest/poi.sh
play=$host/out/play.kgr

kiosk_start() { # LOG SECONDS of the watchdog, OPTIONS...
    log=$host/out/$1
    patience=$2
    shift 2
    wired=''
    for line in $cabinet_wiring; do
        wired="$wired --line $line"
    done
    watchdog_host /dev/watchdog0 "$patience" as kingyo kingyo --lang en --data /tmp/data --poi usb \
        --usb $poi_ids $wired "$@" \
        >$log.out 2>$log.err &
    kiosk=$!
    await 600 has_begun # Compiling the shaders takes minutes if other programs use the processors.
    grep -q 'watchdog_host: ready' $log.err
}

has_begun() { # Returns 0 if the kiosk has begun or has ended.
    grep -q 'watchdog_host: ready' $log.err || ! kill -0 $kiosk
}

print_logs() {
    sed 's/^/0 # /' $log.out $log.err >>$talk
}

read_count() { # NAME: Prints a value of the recording as the host computed it a moment ago (state_writer.c).
    sed -n "s/^$1 //p" $host/seen 2>/dev/null
}

reads() { # NAME OPERATOR NUMBER
    test "$(read_count "$1")" "$2" "$3" 2>/dev/null
}

# Keeps a round running. If no round is ready, inserts coins if necessary and presses START.
play_on() {
    if reads is_round -eq 0 && reads is_ready -eq 0; then
        reads credits -gt 0 || coins 2 >/dev/null
        press START
    fi
}

modprobe virtio-gpu
modprobe i6300esb
await 10 test -e /dev/dri/card0
await 10 test -e /dev/watchdog0
cabinet_open
poi_make
poi_is_watched
poi_is_given
jam
meter_begin
kiosk_start kingyo 120 --mode festival --grade 4 --coins 2 --fish 40 --seed 3 --record $play
found $? screen "$(sed -n 's/.*display *//p' $host/out/kingyo.out | head -1), first picture $(now_ms) ms after power on"
print_logs
is_kingyo "$(pidof kingyo)"
found $? user "kingyo, in $(groups_of "$(pidof kingyo)")"
await 20 is_held START && await 20 is_held COIN
found $? lines "$(gpioinfo | grep -c kingyo) lines held by name"
await 120 reads ticks -gt 240
shot attract
cp -r /tmp/mesa $host/out/ # With these shaders the next guest draws its first picture earlier.

# Coins and START. Two coins are a credit, and a credit is a round. The lamp of START blinks while
# there is a credit.
await 20 is_lit LOCKOUT
found $? lockout 'accepts coins in attract mode'
! await 3 is_lit LAMP
dark=$?
coins 2 >/dev/null
await 20 reads credits -eq 1
found $? coin "2 pulses: $(read_count coins) coins, $(read_count credits) credit"
await 20 is_lit LAMP && await 20 is_dark LAMP && [ $dark -eq 0 ]
found $? lamp 'dark without a credit, blinks with a credit'
press START
await 20 reads rounds -eq 1
found $? start "$(read_count start) press, round $(read_count rounds), $(read_count credits) credits left"

# The program scoop_planner on the host plans a motion to a fish and sends it to the gadget. A round lasts
# at most a minute, so another round may start meanwhile.
say 'plan'
end=$(($(now_ms) + 1000 * $(cat $host/patience)))
until [ -e $host/plan-done ] || [ "$(now_ms)" -gt $end ]; do
    sleep 2
    play_on
done
found "$(cat $host/plan-done 2>/dev/null || echo 1)" fish "$(tail -n 1 $host/plan.log)"
shot caught

# The cable is unplugged during a round.
until reads is_round -eq 1 || [ "$(now_ms)" -gt $((end + 60000)) ]; do
    sleep 1
    play_on
done
coins 2 >/dev/null # An unused credit must not be lost either.
await 20 reads credits -ge 1
round=$(read_count rounds)
credits=$(read_count credits)
spans=$(read_count lost_spans)
began=$(now_ms)
poi_unplug
await 30 reads lost_spans -gt "${spans:-0}"
await 30 reads paused -eq 1
found $? unplug "the clock stopped, as the host saw $(($(now_ms) - began)) ms later"
await 10 is_dark LOCKOUT
found $? lockout 'without a poi coins are rejected'
shot paused dark
sleep 1
poi_plug
plugged=$(now_ms)
await 20 poi_is_taken
taken=$(now_ms)
await 30 reads paused -eq 0
found $? replug "unplugged for $((plugged - began)) ms; the kiosk opened the poi $((taken - plugged)) ms after the plug"
reads is_round -eq 1 && reads rounds -eq "${round:-x}" && reads credits -eq "${credits:-x}"
found $? credit "round $(read_count rounds) continues, $(read_count credits) credits are unchanged"
shot resumed light

# The door and the tilt switch. An open door rejects coins, and both are recorded.
await 20 is_lit LOCKOUT
found $? lockout 'with the poi coins are accepted again'
echo pull-down >"$(wire DOOR)/pull"
await 20 reads door -eq 1 && await 20 is_dark LOCKOUT
found $? door 'open, and coins are rejected'
echo pull-up >"$(wire DOOR)/pull"
await 20 is_lit LOCKOUT
found $? lockout 'with a closed door coins are accepted'
press TILT
await 20 reads tilt -eq 1
found $? door "door $(read_count door), tilt $(read_count tilt)"

# 200 coins by real edges, then a pulse that is too short and one that is too long. The meter
# counts every coin.
before=$(read_count coins)
pulses=$(coins 200)
await 20 reads coins -ge $((before + 200))
# If the guest is delayed while the line is active, the short pulse becomes a valid coin. panel
# reports how often this happened.
longer=$(panel pulse "$(wire COIN)" 5 300 1 0 14 | sed 's/.*, \([0-9]*\) longer$/\1/')
due=$((200 + longer))
panel pulse "$(wire COIN)" 400 300 1 251 5000 >/dev/null
sleep 2
counted=$(($(read_count coins) - before))
[ $counted -eq $due ]
found $? coins "$counted, $due due: $pulses"
await 90 has_metered "$(read_count coins)"
found $? meter "$(cat /run/meter) pulses for $(read_count coins) coins"

# The chip of the lines is removed and restored.
cabinet_pull_out
sleep 2
kill -0 $kiosk
found $? chip-away 'the kiosk runs without lines'
cabinet_plug
await 20 is_held START && await 20 is_held COIN
before=$(read_count coins)
coins 2 >/dev/null
await 20 reads coins -eq $((before + 2))
found $? chip-back "$(gpioinfo | grep -c kingyo) lines held again, $(($(read_count coins) - before)) of 2 pulses counted"

await 20 has_metered "$(read_count coins)"
found $? meter "$(cat /run/meter) pulses for $(read_count coins) coins, including those after the chip was restored"
kill -TERM $kiosk
wait $kiosk
status=$?
found $status end "exit code $status"
is_dark LOCKOUT
found $? lockout 'open in attract mode; closed without a poi, with an open door or without a kiosk'
kill $meter
print_logs
poi_stop
dmesg >$host/out/dmesg
