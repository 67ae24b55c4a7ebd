# kept.sh -- copies the saved data to the host before the kiosk opens its database. The copy is
# complete or missing.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # the sourced files set these variables
. /run/host/guest/common.sh
mkdir -p $host/out/kept.new
cp /var/lib/kingyo/kingyo.db* $host/out/kept.new/ 2>/dev/null
cat /run/kingyo-data >$host/out/kept.new/data 2>/dev/null
mv $host/out/kept.new $host/out/kept
