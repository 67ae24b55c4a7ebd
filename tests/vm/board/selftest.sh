#!/bin/bash
# selftest.sh -- starts the card of `make image BOARD=rpi4` in QEMU's machine `virt` with the word kingyo.selftest, waits until
# the machine switches itself off, and reads the report from the first partition of the card. The picture is small and drawn by
# Mesa's softpipe, because the emulator needs minutes to compile shaders. Exit code 0: all checks passed.
# shellcheck disable=SC2154,SC1091,SC2034  # the sourced files set and use these variables
export BUILD=${BUILD:-build} CARD=rpi4
. "$(dirname "$0")/../image/disk.sh" rpi4-selftest
limit_s=${VM_SECONDS:-3600} seconds=${SECONDS_OF_PLAY:-30}
test_words="$test_words kingyo.selftest=$seconds"
report=$cache/selftest.txt data=$cache/data.ext4
trap guest_stop EXIT
trap 'exit 143' TERM INT HUP

heard() { printf '       %s\n' "$*"; }

# Of the test's units only those of the screen and the wires stay. The others wait for the kiosk.
share_units() {
    local folder=$share/units/kingyo-selftest.service.d
    rm "$share"/units/multi-user.target.wants/kingyo-test{,-kept,-photo}.service
    mkdir -p "$folder"
    printf '[Unit]\nAfter=kingyo-test-wires.service\n[Service]\nEnvironment=GALLIUM_DRIVER=softpipe\n' >"$folder/test.conf"
}

has_parts() {
    grep -q 'self-test of a board' "$report" && grep -q '^---- start ----' "$report" &&
        grep -q '^---- warnings of the kernel ----' "$report"
}

plays() {
    grep -q '^frames  *[1-9][0-9]* in ' "$report" && grep -q '^drawn by  *.*softpipe' "$report" &&
        grep -q '^---- exit code 0 ----' "$report"
}

# systemctl ends its list with the number of its lines, so that no list is no pass.
units_listed() { sed -n '/^---- failed units ----/,/^---- warnings of the kernel/p' "$report"; }
no_unit_failed() { units_listed | grep -q '^0 loaded units listed'; }

copy_data() {
    local start size
    read -r start size < <(sfdisk -d "$disk" | sed -n 's/^[^ ]*4 : start= *\([0-9]*\), size= *\([0-9]*\),.*/\1 \2/p')
    dd if="$disk" of="$data" bs=512 skip="$start" count="$size" conv=sparse status=none
}

files_of_data() { debugfs -R 'ls -p /' "$data" 2>/dev/null | cut -d/ -f6 | tr '\n' ' '; }

# Without lost+found the partition was not read.
has_no_takings() { [[ " $(files_of_data) " == *' lost+found '* && $(files_of_data) != *kingyo.db* ]]; }

make_test_initrd
make_share none
share_units
fresh_disk
step "boots the card with a self-test of $seconds s"
guest_start "$limit_s"
guest_listen
step "the machine is off (qemu ended with $qemu_status)"
rm -f "$report"
mcopy -i "$disk@@$boot_at" ::selftest.txt "$report" || : >"$report"
copy_data
passes off "qemu ended with $qemu_status" -- [ "$qemu_status" -eq 0 ]
passes report "$(wc -l <"$report") lines" -- has_parts
passes plays "$(grep -E '^(frames|first picture) ' "$report" | tr -s ' ' | tr '\n' ';')" -- plays
passes doctor "$(sed -n '/exit code/,/start ----/p' "$report" | sed '1d;$d' | wc -l) lines" -- grep -qE '^(fine|check|WRONG) ' "$report"
passes units "$(units_listed | grep -m1 'loaded failed\|units listed' || echo 'no list')" -- no_unit_failed
passes takings "files: $(files_of_data)" -- has_no_takings
rm -f "$data"
table "$here/board/selftest_checks.txt" "the self-test of the card" | tee "$cache/table.txt"
exit "${PIPESTATUS[0]}"
