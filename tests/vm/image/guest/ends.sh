# ends.sh -- SIGKILL and a hanging thread: the kiosk restarts and keeps its credits.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # stall.sh sources this file
await 60 is_lit LOCKOUT
coins 4 >/dev/null
await 30 reads credits -ge 2
sleep 2 # After this time the credits are saved and recorded.
credits=$(read_count credits)
# The next start uses the default watchdog time, because all shaders are compiled now.
rm /run/systemd/system/kingyo.service.d/patience.conf
systemctl daemon-reload
starts=$(unit_property NRestarts)
killed=$(now_ms)
kill -9 "$(unit_property MainPID)"
took=$(opens_again "$starts" "$killed" 200)
follow
await 30 reads ticks -gt 60
[ "$took" -gt 0 ] && reads credits -eq "$credits"
found $? kill "next picture $took ms after kill -9; $(read_count credits) credits, $credits before"

# Only the thread that draws is stopped. No other thread may feed the watchdog.
starts=$(unit_property NRestarts)
hung=$(now_ms)
hold "$(unit_property MainPID)" &
holder=$!
took=$(opens_again "$starts" "$hung" 260)
kill $holder 2>/dev/null
follow
await 30 reads ticks -gt 60
journalctl -b --no-pager -u kingyo.service | grep -qi 'watchdog timeout'
found $? hang 'systemd reports a watchdog timeout'
[ "$took" -gt 0 ] && reads credits -eq "$credits"
found $? hang "next picture $took ms after the thread was stopped (WatchdogSec=$(unit_property WatchdogUSec)); $(read_count credits) credits"
