# late.sh -- the driver of the screen is loaded last (board/units/kingyo-test-screen.service): the kiosk must start after it.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # stall.sh sources this file
entered_us() { # UNIT: the time at which the unit became active, in µs after the start of the kernel
    systemctl show -P ActiveEnterTimestampMonotonic "$1"
}

screen=$(entered_us dev-kingyo-screen.device) others=$(entered_us kingyo-test-kept.service)
kiosk=$(unit_property ExecMainStartTimestampMonotonic)
[ "$(systemctl is-active dev-kingyo-screen.device)" = active ] && [ "$(unit_property NRestarts)" = 0 ] &&
    [ "$others" -gt 0 ] && [ "$screen" -ge $((others + 14000000)) ] && [ "$kiosk" -ge "$screen" ]
found $? waits "screen $(((screen - others) / 1000)) ms after all else; kiosk $(((kiosk - screen) / 1000)) ms after the screen"
