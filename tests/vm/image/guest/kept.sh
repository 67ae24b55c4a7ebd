# kept.sh -- before the stall opens its store: what it kept until now is shown outside, all of it or nothing.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # it sources what it uses
. /run/host/guest/common.sh
mkdir -p $host/out/kept.new
cp /var/lib/kingyo/kingyo.db* $host/out/kept.new/ 2>/dev/null
cat /run/kingyo-data >$host/out/kept.new/data 2>/dev/null
mv $host/out/kept.new $host/out/kept
