# qemu.sh -- starts the guest, reads its messages and takes its pictures. Source it after lib.sh.
# The guest writes lines to share/out/talk (guest/lib.sh). QEMU takes pictures on request and
# reports events of its machine, such as an expired watchdog, through QMP on two pipes.
# shellcheck shell=bash disable=SC2154,SC2054,SC2086,SC2046,SC2034  # QEMU needs the commas
run=$cache/run share=$cache/run/share
qemu_pid='' qmp_in='' qmp_reader='' qmp_id=0

qemu_words() { # The machine has 2 processors and 1 GiB. QEMU emulates only devices that the kiosk uses.
    local words=(-nodefaults -no-user-config -display none -smp 2 -m 1024 -kernel "$cache/kernel/image"
        -initrd "$cache/initrd.zst" -no-reboot -action watchdog=reset
        -drive "file=$cache/root.sqfs,format=raw,if=virtio,readonly=on"
        -fsdev "local,id=host,path=$share,security_model=none" -device virtio-9p-pci,fsdev=host,mount_tag=host
        -device "virtio-gpu-pci,xres=$width,yres=$height,edid=off" -device i6300esb
        -serial "file:$run/console" -qmp "pipe:$run/qmp" -accel tcg,thread=multi,tb-size=512)
    local append='quiet loglevel=4 mitigations=off panic=-1'
    case $arch in
        # AVX is disabled, because VPGATHERDD of QEMU 7.2 faults in code that LLVM 19 generates for
        # Mesa 25. AVX would not be faster.
        amd64) words+=(-machine q35 -cpu qemu64,+ssse3,+sse4.1,+sse4.2,+popcnt -append "console=ttyS0 $append") ;;
        arm64) words+=(-machine virt -cpu cortex-a72 -append "console=ttyAMA0 $append") ;;
    esac
    printf '%s\n' "${words[@]}"
}

qmp() { # COMMAND [ARGUMENTS]: Waits until QEMU has executed the command.
    qmp_id=$((qmp_id + 1))
    printf '{"execute":"%s","arguments":{%s},"id":%d}\n' "$1" "${2-}" "$qmp_id" >&"$qmp_in"
    for _ in $(seq 200); do
        grep -q "\"id\": $qmp_id\b" "$run/qmp.log" && break
        kill -0 "$qemu_pid" 2>/dev/null || return 1
        sleep 0.05
    done
    ! grep "\"id\": $qmp_id\b" "$run/qmp.log" | grep -q '"error"'
}

guest_start() { # LIMIT_S
    local -a words
    rm -f "$run"/qmp.in "$run"/qmp.out "$run"/qmp.log
    mkfifo "$run/qmp.in" "$run/qmp.out"
    : >"$share/out/talk"
    : >"$run/qmp.log"
    mapfile -t words < <(qemu_words)
    exec {qmp_in}<>"$run/qmp.in"
    cat "$run/qmp.out" >"$run/qmp.log" &
    qmp_reader=$!
    # The guest ends when this shell ends.
    setpriv --pdeathsig TERM timeout --signal=KILL "$1" "qemu-system-$machine" "${words[@]}" >"$run/qemu.log" 2>&1 &
    qemu_pid=$!
    qmp qmp_capabilities
}

MIDDLE_DARK=250 MIDDLE_LIGHT=290 # Measured values by night: 209 under "Paused", 337 otherwise.

# Prints the brightness of the middle of a picture in thousandths. The message of a paused round
# covers the middle.
middle() { # FILE
    convert "$1" -crop 100%x20%+0+88 +repage -resize '1x1!' -colorspace Gray -format '%[fx:int(1000*mean)]' info: 2>/dev/null || echo 0
}

# A guest draws a picture in a second or more, and shows it one picture later. The function
# therefore waits for the requested brightness, or until the picture shows the tank (results.sh).
guest_shot() { # NAME [dark|light|tank], of build/vm/GUEST/shots/NAME.png
    local file=$cache/shots/$1.png try tries=40
    [ "${2-}" != tank ] || tries=160
    for ((try = 0; try < tries; try++)); do
        qmp screendump "\"filename\":\"$file\",\"format\":\"png\"" || return 0
        case ${2-} in
            dark) [ "$(middle "$file")" -lt "$MIDDLE_DARK" ] && break ;;
            light) [ "$(middle "$file")" -gt "$MIDDLE_LIGHT" ] && break ;;
            tank) shows_tank $(picture "$1") && break ;;
            *) break ;;
        esac
        sleep 0.5
    done
    : >"$share/shots/$1.done"
}

# Runs until the guest is off: takes requested pictures, and passes each line to heard().
guest_listen() {
    local line
    while read -r line; do
        line=${line%$'\r'} # A serial console ends its lines with it.
        set -- $line
        [ "${2-}" = shot ] && guest_shot "$3" "${4-}"
        heard "$line"
    done < <(tail -n +1 -s 0.05 -f --pid="$qemu_pid" "$share/out/talk")
    qemu_status=0
    wait "$qemu_pid" 2>/dev/null || qemu_status=$?
    qemu_pid=''
    exec {qmp_in}>&-
    wait "$qmp_reader" 2>/dev/null || true
}

guest_stop() {
    [ -z "$qemu_pid" ] || kill "$qemu_pid" 2>/dev/null || true # timeout(1) passes the signal to QEMU.
    [ -z "$qmp_reader" ] || kill "$qmp_reader" 2>/dev/null || true
}
