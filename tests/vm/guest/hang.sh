# hang.sh -- a kiosk that hangs resets the machine. The last part: nobody comes back from it.
kiosk_start hang 12 --fish 20
sleep 3
say 'the kiosk is stopped'
sync
killall -STOP kingyo
sleep 60
say 'not reset'
