# ends.sh -- the stall is killed, and hangs; its credits are there again.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # stall.sh sources it
await 60 is_lit LOCKOUT
coins 4 >/dev/null
await 30 reads credits -ge 2
sleep 2 # By now they are saved, and the recording says so.
credits=$(read_count credits)
# From its next start on its watchdog is as it ships: by now all shaders are compiled.
rm /run/systemd/system/kingyo.service.d/patience.conf
systemctl daemon-reload
starts=$(asked NRestarts)
killed=$(now_ms)
kill -9 "$(asked MainPID)"
took=$(opens_again "$starts" "$killed" 200)
follow
await 30 reads ticks -gt 60
[ "$took" -gt 0 ] && reads credits -eq "$credits"
found $? kill "its next picture $took ms after kill -9; $(read_count credits) credits, $credits before"

# The thread that draws is stopped, and no other: nobody else may say that the stall lives.
starts=$(asked NRestarts)
hung=$(now_ms)
hold "$(asked MainPID)" &
holder=$!
took=$(opens_again "$starts" "$hung" 260)
kill $holder 2>/dev/null
follow
await 30 reads ticks -gt 60
journalctl -b --no-pager -u kingyo.service | grep -qi 'watchdog timeout'
found $? hang 'systemd says: watchdog timeout'
[ "$took" -gt 0 ] && reads credits -eq "$credits"
found $? hang "its next picture $took ms after its thread stood still (WatchdogSec=$(asked WatchdogUSec)); $(read_count credits) credits"
