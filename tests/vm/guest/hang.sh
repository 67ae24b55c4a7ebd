# hang.sh -- a kiosk that hangs resets the machine. This part runs last, because the guest does not
# continue afterwards.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # init sources all files of this folder
kiosk_start hang 12 --fish 20
sleep 3
say 'the kiosk is stopped'
sync
killall -STOP kingyo
sleep 60
say 'not reset'
