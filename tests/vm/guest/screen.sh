# screen.sh -- experiment
modprobe virtio-gpu
await 10 test -e /dev/dri/card0
cp /host/bin/kingyo /tmp/kingyo
for envs in A B; do cat /sys/class/drm/card0-*/modes >> $talk
say "start $envs"
env B=$envs MESA_SHADER_CACHE_DIR=/tmp/mesa SDL_VIDEODRIVER=kmsdrm SDL_AUDIODRIVER=dummy /tmp/kingyo --data /tmp/data --lang en --fish 40 --record /tmp/$envs.kgr \
    >/host/out/kingyo.out 2>/host/out/kingyo.err &
kiosk=$!
await 60 grep -q watchdog\\\|store /host/out/kingyo.out
say "opened"
sleep 20
shot $envs
sleep 15
kill -TERM $kiosk
wait $kiosk
say "kiosk ended with $?"
cat /host/out/kingyo.out >>$talk
du -s /tmp/mesa >> $talk
done
