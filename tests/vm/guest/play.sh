# play.sh -- an evening: coins, START, a fish by the USB poi, cables pulled and put back, the end.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # init sources all of them
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
    keeper /dev/watchdog0 "$patience" as kingyo kingyo --lang en --data /tmp/data --poi usb \
        --usb $poi_ids $wired "$@" \
        >$log.out 2>$log.err &
    kiosk=$!
    await 600 has_begun # Shaders that nobody compiled before take minutes where others have the processors, too.
    grep -q 'keeper: ready' $log.err
}

has_begun() { # Or will not
    grep -q 'keeper: ready' $log.err || ! kill -0 $kiosk
}

tell_logs() {
    sed 's/^/0 # /' $log.out $log.err >>$talk
}

read_count() { # NAME: what the machine outside says of the recording (look.c), a moment ago
    sed -n "s/^$1 //p" $host/seen 2>/dev/null
}

reads() { # NAME OPERATOR NUMBER
    test "$(read_count "$1")" "$2" "$3" 2>/dev/null
}

# Keeps a round going: paid for, if it must be, and started.
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
tell_logs
is_kingyo "$(pidof kingyo)"
found $? user "kingyo, in $(groups_of "$(pidof kingyo)")"
await 20 is_held START && await 20 is_held COIN
found $? lines "$(gpioinfo | grep -c kingyo) lines held by name"
await 120 reads ticks -gt 240
shot attract
cp -r /tmp/mesa $host/out/ # The next guest's first picture comes the sooner.

# Coins, then START. Two coins are a credit, the credit is a round. The lamp of START blinks for it.
await 20 is_lit LOCKOUT
found $? lockout 'lets coins in where one can play'
! await 3 is_lit LAMP
dark=$?
coins 2 >/dev/null
await 20 reads credits -eq 1
found $? coin "2 pulses: $(read_count coins) coins, $(read_count credits) credit"
await 20 is_lit LAMP && await 20 is_dark LAMP && [ $dark -eq 0 ]
found $? lamp 'dark before, lit and dark and so on with a credit'
press START
await 20 reads rounds -eq 1
found $? start "$(read_count start) press, round $(read_count rounds), $(read_count credits) credits left"

# The hand outside thinks of a way to a fish and sends it; here it goes to the gadget. A round lasts a
# minute at most, so there may be another one meanwhile.
say 'hand'
end=$(($(now_ms) + 1000 * $(cat $host/patience)))
until [ -e $host/hand-done ] || [ "$(now_ms)" -gt $end ]; do
    sleep 2
    play_on
done
found "$(cat $host/hand-done 2>/dev/null || echo 1)" fish "$(tail -n 1 $host/hand.log)"
shot caught

# The cable, in mid-round.
until reads is_round -eq 1 || [ "$(now_ms)" -gt $((end + 60000)) ]; do
    sleep 1
    play_on
done
coins 2 >/dev/null # A credit that lies ready may not be lost either.
await 20 reads credits -ge 1
round=$(read_count rounds)
credits=$(read_count credits)
spans=$(read_count lost_spans)
began=$(now_ms)
poi_unplug
await 30 reads lost_spans -gt "${spans:-0}"
await 30 reads paused -eq 1
found $? unplug "the clock stands, as seen from outside $(($(now_ms) - began)) ms after"
await 10 is_dark LOCKOUT
found $? lockout 'without a poi coins are sent back'
shot paused dark
sleep 1
poi_plug
plugged=$(now_ms)
await 20 poi_is_taken
taken=$(now_ms)
await 30 reads paused -eq 0
found $? replug "out for $((plugged - began)) ms; the kiosk had it again $((taken - plugged)) ms after the plug"
reads is_round -eq 1 && reads rounds -eq "${round:-x}" && reads credits -eq "${credits:-x}"
found $? credit "round $(read_count rounds) of before goes on, $(read_count credits) credits as before"
shot resumed light

# The door, and a shove: both send coins back, and are told.
await 20 is_lit LOCKOUT
found $? lockout 'with the poi they are let in again'
echo pull-down >"$(wire DOOR)/pull"
await 20 reads door -eq 1 && await 20 is_dark LOCKOUT
found $? door 'open, and coins are sent back'
echo pull-up >"$(wire DOOR)/pull"
await 20 is_lit LOCKOUT
found $? lockout 'with the door shut, too'
press TILT
await 20 reads tilt -eq 1
found $? door "door $(read_count door), tilt $(read_count tilt)"

# 200 coins by real edges, then a pulse too short and one that sticks; the meter has every coin.
before=$(read_count coins)
pulses=$(coins 200)
await 20 reads coins -ge $((before + 200))
# A guest that stands still while the line is up makes a true coin of the short one: panel saw how often.
longer=$(panel pulse "$(wire COIN)" 5 300 1 0 14 | sed 's/.*, \([0-9]*\) longer$/\1/')
due=$((200 + longer))
panel pulse "$(wire COIN)" 400 300 1 251 5000 >/dev/null
sleep 2
counted=$(($(read_count coins) - before))
[ $counted -eq $due ]
found $? coins "$counted, $due due: $pulses"
await 90 has_metered "$(read_count coins)"
found $? meter "$(cat /run/meter) pulses for $(read_count coins) coins"

# The wires' chip, pulled away and back.
cabinet_pull_out
sleep 2
kill -0 $kiosk
found $? chip-away 'it runs, without lines'
cabinet_plug
await 20 is_held START && await 20 is_held COIN
before=$(read_count coins)
coins 2 >/dev/null
await 20 reads coins -eq $((before + 2))
found $? chip-back "$(gpioinfo | grep -c kingyo) lines held again, $(($(read_count coins) - before)) of 2 pulses counted"

await 20 has_metered "$(read_count coins)"
found $? meter "$(cat /run/meter) pulses for $(read_count coins) coins, the chip's way included"
kill -TERM $kiosk
wait $kiosk
status=$?
found $status end "exit code $status"
is_dark LOCKOUT
found $? lockout 'open where one can play; shut without a poi, with an open door, without a kiosk'
kill $meter
tell_logs
poi_stop
dmesg >$host/out/dmesg
