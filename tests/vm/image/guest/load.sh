# load.sh -- coins fall and rounds run until the machine is no more.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # it sources what it uses
. /run/host/guest/common.sh
poi_hold
systemctl start kingyo.service || say 'bad open' # It is on its way: this waits until it says that it is ready.
await 100 is_lit LOCKOUT || say 'bad lockout'
[ -d $host/mesa ] || keep_shaders
say 'load'
fallen=0
while :; do
    fallen=$((fallen + 1))
    say "coin $fallen" # Before it falls: no more than these can ever be counted.
    coins 1 >/dev/null
    [ $((fallen % 3)) -ne 0 ] || press START
done
