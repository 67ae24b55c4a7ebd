#!/bin/bash
# test-image.sh -- boots the unchanged disk of `make image BOARD=vm`, drives the kiosk from outside
# and checks the results. CARD=rpi4 boots the card of that board in QEMU's machine `virt`.
# PARTS ("round screen hostile ends", and "late" for a card) selects the parts. Checks of other parts are printed as not
# run. Logs and pictures are in BUILD/vm/image. Exit code 0 if every line of checks.txt passed,
# otherwise 1.
# shellcheck disable=SC2154,SC1091,SC2034  # the sourced files set and use these variables
export BUILD=${BUILD:-build}
. "$(dirname "$0")/disk.sh" "${CARD:-image}"
limit_s=${VM_SECONDS:-1300}
writer_pid=''

leave() {
    guest_stop
    [ -z "$writer_pid" ] || kill "$writer_pid" 2>/dev/null || true
}
trap leave EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

follow() { # RECORDING
    [ -z "$writer_pid" ] || kill "$writer_pid" 2>/dev/null || true
    "$BUILD/tests/vm/state_writer" "$share/out/$1" "$share/seen" &
    writer_pid=$!
}

# Types the keys of an attacker: a coin and the menu of a desktop kiosk, quit, another console, a
# reboot and a reset.
type_keys() {
    local keys
    for keys in 5 f2 esc alt-f2 ctrl-alt-f3 ctrl-alt-delete alt-sysrq-b alt-sysrq-k; do
        keyboard "$keys"
        sleep 0.3
    done
    for _ in 1 2 3 4 5 6 7 8; do # systemd reboots after seven presses in two seconds if this is enabled.
        keyboard ctrl-alt-delete
    done
    echo '5, F2, Esc, Alt-F2, Ctrl-Alt-F3, Ctrl-Alt-Del (8 times), Alt-SysRq-b and -k' >"$share/keys-done"
}

keyboard() { # KEYS, joined by a dash
    local key words=''
    for key in ${1//-/ }; do
        words+="${words:+,}{\"type\":\"qcode\",\"data\":\"$key\"}"
    done
    qmp send-key "\"keys\":[$words]"
}

heard() { # Handles one line from the guest (tests/vm/guest/lib.sh).
    set -- $1
    case ${2-} in
        ok | bad) record_result "${@:2}" ;;
        recording) follow "$3" ;;
        keys) type_keys ;;
    esac
    printf '       %s\n' "$*"
}

# Prints kernel warnings except those of the device side of the foreign cable (dummy_hcd,
# libcomposite). The device side warns if it is unplugged during a transfer, and a real kiosk does
# not have it.
warnings() {
    grep -hE 'WARNING: |refcount_t' "${files[@]}" 2>/dev/null | grep -v ' at drivers/usb/gadget/' | head -1 || true
}

check_logs() {
    local line files=("$run/console" "$share/out/dmesg" "$share/out/journal")
    line=$(first 'BUG:|Oops|segfault|general protection|Kernel panic|hung task' "${files[@]}")
    [ -n "$line" ] || line=$(warnings)
    [ -n "$line" ] || line=$(first 'kingyo\[.*(panic|assert|anitizer)' "$share/out/journal")
    passes crash "${line:-$(wc -l <"$share/out/journal" 2>/dev/null) lines of the journal}" -- [ -z "$line" -a -s "$share/out/journal" ]
    passes off "qemu ended with $qemu_status" -- [ "$qemu_status" -eq 0 ]
}

parts=${PARTS-round screen hostile ends} checks=$run/checks.txt
for part in $parts; do
    grep -q "^[^#][^ ]*  *$part " "$here/image/checks.txt" || {
        echo "test-image: there is no part '$part'" >&2
        exit 2
    }
done
make_test_initrd
make_share stall
echo "$parts" >"$share/parts"
sed 's/^\([^ #]*\)  *[^ ]* */\1 /' "$here/image/checks.txt" >"$checks"
while read -r id part _; do
    case "# always $parts " in *" $part "*) ;; *) verdict[$id]=out ;; esac
done < <(grep -v '^#' "$here/image/checks.txt")
fresh_disk
step 'boot the disk'
guest_start "$limit_s"
guest_listen
step "the machine is off (qemu ended with $qemu_status)"
keep_shaders
check_tank attract picture
[ ! -f "$shots/again.png" ] || check_tank again screen-in
check_logs
table "$checks" "the disk of make image BOARD=${CARD:-vm}" | tee "$cache/table.txt"
exit "${PIPESTATUS[0]}"
