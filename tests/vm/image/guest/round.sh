# round.sh -- coins, START, a poi that is unplugged and replugged in the sandbox, the end of the
# round.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # stall.sh sources this file
await 60 is_held START && await 20 is_held COIN
found $? lines "$(grep -c kingyo /sys/kernel/debug/gpio) lines held by name"
await 60 is_lit LOCKOUT
since=$(now_ms)
coins 2 >/dev/null
await 120 reads credits -ge 1
found $? coin "2 pulses: $(read_count coins) coins, $(read_count credits) credit after $(($(now_ms) - since)) ms"
since=$(now_ms)
press START
await 120 reads is_round -eq 1
found $? start "round $(read_count rounds) after $(($(now_ms) - since)) ms"
spans=$(read_count lost_spans)
since=$(now_ms)
poi_unplug
await 120 reads paused -eq 1
found $? hotplug "unplugged: the round pauses after $(($(now_ms) - since)) ms"
poi_plug
plugged=$(now_ms)
await 120 poi_is_taken
taken=$(now_ms)
await 120 reads paused -eq 0
found $? hotplug "unplugged: the round pauses; opened again $((taken - plugged)) ms after the plug"
await 600 reads is_round -eq 0
found $? round "over; $(read_count caught) caught, $(read_count ticks) ticks"
