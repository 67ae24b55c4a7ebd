# load.sh -- inserts coins and plays rounds until the power is cut.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # the sourced files set these variables
. /run/host/guest/common.sh
poi_hold
# The start job already runs, so this command waits until the kiosk is ready.
systemctl start kingyo.service || say 'bad open'
await 100 is_lit LOCKOUT || say 'bad lockout'
[ -d $host/mesa ] || keep_shaders
say 'load'
fallen=0
while :; do
    fallen=$((fallen + 1))
    say "coin $fallen" # Written before the pulse, so that no more coins than this can be counted.
    coins 1 >/dev/null
    [ $((fallen % 3)) -ne 0 ] || press START
done
