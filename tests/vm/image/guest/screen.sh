# screen.sh -- the screen is pulled out while the stall is open, and plugged in again: the stall plays on, and shows it.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # stall.sh sources it
socket=$(echo /sys/class/drm/card*-*/status)

words_of_the_stall() {
    journalctl --no-pager -o cat -u kingyo.service
}

has_said() { # WORDS, after the first $before lines
    words_of_the_stall | tail -n "+$((before + 1))" | grep -q "$1"
}

before=$(words_of_the_stall | wc -l)
pid=$(asked MainPID)
coins=$(read_count coins)
await 60 is_lit LOCKOUT
echo off >"$socket" # What the kernel says of a socket whose screen is gone.
pulled=$(now_ms)
await 60 has_said 'goes on without a picture'
out=$?
gone=$(($(now_ms) - pulled))
coins 2 >/dev/null
await 30 reads coins -eq $((coins + 2))
[ $? -eq 0 ] && [ $out -eq 0 ] && [ "$(asked MainPID)" = "$pid" ]
found $? screen-out "noticed after $gone ms; $(($(read_count coins) - coins)) of 2 coins counted meanwhile"
echo detect >"$socket"
plugged=$(now_ms)
await 120 has_said 'OpenGL ES'
back=$?
took=$(($(now_ms) - plugged))
ticks=$(read_count ticks)
await 60 reads ticks -gt $((ticks + 60))
[ $? -eq 0 ] && [ $back -eq 0 ] && [ "$(asked MainPID)" = "$pid" ]
found $? screen-in "its picture again $took ms after the plug, and no other process"
await 90 reads phase -eq 0 # The last round's result lies over the tank until it is attract again.
shot again
