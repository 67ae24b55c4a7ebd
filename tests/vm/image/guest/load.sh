# load.sh -- coins fall and rounds run until the machine is no more.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # it sources what it uses
. /run/host/guest/common.sh
say "booted $(uname -rm)"
poi_hold
await 900 is_open || say 'bad open'
say "recording play-$(asked MainPID).kgr"
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
