# screen.sh -- the screen is disconnected and connected again while the kiosk runs. The kiosk must
# continue and draw again.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # stall.sh sources this file
socket=$(echo /sys/class/drm/card*-*/status)

words_of_the_stall() {
    journalctl --no-pager -o cat -u kingyo.service
}

log_contains() { # Searches the log after its first $before lines.
    words_of_the_stall | tail -n "+$((before + 1))" | grep -q "$1"
}

before=$(words_of_the_stall | wc -l)
pid=$(unit_property MainPID)
coins=$(read_count coins)
await 60 is_lit LOCKOUT
echo off >"$socket" # The kernel reports this state for a disconnected screen.
pulled=$(now_ms)
await 60 log_contains 'continues without a picture'
out=$?
gone=$(($(now_ms) - pulled))
coins 2 >/dev/null
await 30 reads coins -eq $((coins + 2))
[ $? -eq 0 ] && [ $out -eq 0 ] && [ "$(unit_property MainPID)" = "$pid" ]
found $? screen-out "noticed after $gone ms; $(($(read_count coins) - coins)) of 2 coins counted meanwhile"
echo detect >"$socket"
plugged=$(now_ms)
await 120 log_contains 'OpenGL ES'
back=$?
took=$(($(now_ms) - plugged))
ticks=$(read_count ticks)
await 60 reads ticks -gt $((ticks + 60))
[ $? -eq 0 ] && [ $back -eq 0 ] && [ "$(unit_property MainPID)" = "$pid" ]
found $? screen-in "picture $took ms after the plug, in the same process"
await 90 reads phase -eq 0 # The result of the last round covers the tank until attract mode begins.
shot again
