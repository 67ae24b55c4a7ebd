#!/bin/bash
# test_poi_gadget.sh -- kingyo-poi-gadget on a simulated configfs of folders, under each installed
# shell.
# The folder behaves like configfs: attributes disappear with their directory, and a directory that
# contains directories or links cannot be removed (Documentation/filesystems/configfs.rst).
# tests/vm uses the real configfs. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
build=$(realpath "$build")
gadget_script=$(realpath board/poi-gadget/kingyo-poi-gadget)

# A machine with one USB device controller. System commands are replaced by functions, because
# busybox prefers its own commands to programs. The test does not touch the kernel of this machine.
mkdir "$work/bin"
cat >"$work/commands" <<END
mount() { :; }
modprobe() { :; }
rmdir() { "$work/bin/rmdir" "\$@"; }
mkdir() { "$work/bin/mkdir" "\$@"; }
END
ln -s /bin/mkdir "$work/bin/mkdir"
cat >"$work/bin/rmdir" <<'END'
#!/bin/bash
for folder; do
    for entry in "$folder"/*; do
        if [ -L "$entry" ]; then echo "rmdir: $folder: a link is in it" >&2; exit 1; fi
        if [ -d "$entry" ] && [ -n "$(ls "$entry")" ]; then
            echo "rmdir: $folder: $entry is not empty" >&2
            exit 1
        fi
    done
    rm -r "$folder"
done
END
chmod +x "$work/bin"/*

fresh() { # Creates a new machine without a gadget and without settings.
    rm -rf "$work/config" "$work/sys" "$work/conf"
    mkdir -p "$work/config/usb_gadget" "$work/sys/class/udc/fe980000.usb" "$work/sys/dev/char/240:0"
    echo configured >"$work/sys/class/udc/fe980000.usb/state"
    echo DEVNAME=hidg0 >"$work/sys/dev/char/240:0/uevent"
    mkdir -p "$work/sys/firmware/devicetree/base"
    printf '00000000deadbeef\0' >"$work/sys/firmware/devicetree/base/serial-number"
}

script() { # ARGUMENTS: The output goes to "$work/words".
    # shellcheck disable=SC2016
    COMMANDS=$work/commands CONFIGFS=$work/config SYSFS=$work/sys MACHINE_ID=$work/machine-id \
        KINGYO_POI_GADGET_CONF=$work/conf \
        $shell -c '. "$COMMANDS"; . "$0"' "$gadget_script" "$@" >"$work/words" 2>&1
}

g=$work/config/usb_gadget/kingyo-poi
ids='VENDOR=0x1209 PRODUCT=0x0001'
poi=POI=$build/kingyo-poi

refuses() { # CODE PATTERN ARGUMENTS...: The script fails and leaves nothing behind.
    local code=$1 pattern=$2 status
    shift 2
    script "$@"
    status=$?
    cat "$work/words"
    [ $status -eq "$code" ] && grep -q -- "$pattern" "$work/words" && [ ! -e "$g" ]
}

holds() { # FILE TEXT
    echo "$1: '$(cat "$g/$1")', expected '$2'"
    [ "$(cat "$g/$1")" = "$2" ]
}

starts() {
    fresh
    # shellcheck disable=SC2086
    script start $ids "$poi" || { cat "$work/words"; return 1; }
    holds idVendor 0x1209 && holds idProduct 0x0001 && holds functions/hid.poi/report_length 17 &&
        holds functions/hid.poi/protocol 0 && holds UDC fe980000.usb &&
        holds strings/0x409/serialnumber 00000000deadbeef &&
        cmp "$g/functions/hid.poi/report_desc" <("$build/kingyo-poi" descriptor) &&
        [ "$(readlink -f "$g/configs/c.1/hid.poi")" = "$(readlink -f "$g/functions/hid.poi")" ]
}

interval() { # Linux 6.16 has this attribute, which exists after the function was created.
    fresh
    rm "$work/bin/mkdir"
    cat >"$work/bin/mkdir" <<'END'
#!/bin/bash
/bin/mkdir "$@" || exit
for folder; do case $folder in */functions/hid.poi) : >"$folder/interval" ;; esac; done
END
    chmod +x "$work/bin/mkdir"
    # shellcheck disable=SC2086
    script start $ids "$poi"
    local status=$?
    ln -sf /bin/mkdir "$work/bin/mkdir"
    [ $status -eq 0 ] && holds functions/hid.poi/interval 4
}

status_prints() { # PATTERN CODE: The status command prints PATTERN.
    script status
    local status=$?
    cat "$work/words"
    [ $status -eq "$2" ] && grep -q -- "$1" "$work/words"
}

plugs() {
    starts || return 1
    echo 240:0 >"$g/functions/hid.poi/dev"
    status_prints "0x1209:0x0001.*configured, reports through /dev/hidg0" 0 || return 1
    script detach && holds UDC '' && status_prints detached 1 || return 1
    script attach && holds UDC fe980000.usb
}

stops() {
    starts && script stop && [ ! -e "$g" ] && status_prints 'no gadget' 1 && script stop
}

starts_once() {
    starts || return 1
    # shellcheck disable=SC2086
    ! script start $ids "$poi" && grep -q 'stop it first' "$work/words" && holds UDC fe980000.usb
}

reads_settings() {
    fresh
    printf '# mine\nVENDOR=0x1d50\nPRODUCT=0xABCD\n\nSERIAL=poi 7\nNAME=Red poi' >"$work/conf"
    script start "$poi" SERIAL=eight && holds idVendor 0x1d50 && holds idProduct 0xABCD &&
        holds strings/0x409/serialnumber eight && holds strings/0x409/product 'Red poi'
}

hides() { # A board without a serial number.
    local id=0123456789abcdef0123456789abcdef first
    fresh
    rm "$work/sys/firmware/devicetree/base/serial-number"
    echo $id >"$work/machine-id"
    # shellcheck disable=SC2086
    script start $ids "$poi" || return 1
    first=$(cat "$g/strings/0x409/serialnumber")
    echo "serial number '$first'"
    [[ $first =~ ^[0-9a-f]{16}$ ]] && ! grep -rq "${id:0:8}" "$g" || return 1
    fresh
    rm "$work/sys/firmware/devicetree/base/serial-number"
    echo "${id//0/f}" >"$work/machine-id"
    # shellcheck disable=SC2086
    script start $ids "$poi" && [ "$(cat "$g/strings/0x409/serialnumber")" != "$first" ]
}

# The kernel rejects the descriptor. The script must remove the directories that it created.
half_way() {
    fresh
    printf '#!/bin/sh\nexit 74\n' >"$work/bad-poi"
    chmod +x "$work/bad-poi"
    # shellcheck disable=SC2086
    refuses 74 'does not take the descriptor' start $ids "POI=$work/bad-poi"
}

warns() {
    starts && grep -q 'do not give this poi away' "$work/words"
}

shells=()
command -v dash >/dev/null && shells+=('dash')
command -v busybox >/dev/null && shells+=('busybox sh')
[ ${#shells[@]} -gt 0 ] || shells=('sh')
for shell in "${shells[@]}"; do
    check "$shell: start creates a gadget with our descriptor and attaches it" starts
    check "$shell: the test ids print a warning" warns
    check "$shell: the polling interval is 1 ms where the kernel supports it" interval
    check "$shell: detach and attach are reported" plugs
    check "$shell: stop removes the gadget in an order that configfs accepts" stops
    check "$shell: a second start is refused" starts_once
    check "$shell: settings come from the file and from the command line" reads_settings
    check "$shell: the serial number hides the machine-id and differs between machines" hides
    fresh
    check "$shell: missing ids are wrong usage" refuses 2 'its own USB ids' start "$poi"
    check "$shell: a missing product id is wrong usage" refuses 2 'its own USB ids' start VENDOR=0x1209 "$poi"
    check "$shell: an invalid id is wrong usage" refuses 2 'not 0x and four' start VENDOR=4617 PRODUCT=0x0001 "$poi"
    check "$shell: the id 0 is wrong usage" refuses 2 'not 0x and four' start VENDOR=0x1209 PRODUCT=0x0000 "$poi"
    # shellcheck disable=SC2086
    check "$shell: an unknown setting is wrong usage" refuses 2 'is no setting' start $ids COLOUR=red
    echo 'VENDOR 0x1209' >"$work/conf"
    check "$shell: an unknown setting of the file is reported with its line" refuses 65 'conf:1' start "$poi"
    rm "$work/conf"
    mkdir "$work/sys/class/udc/other"
    # shellcheck disable=SC2086
    check "$shell: two controllers need UDC=" refuses 2 'choose one by UDC=' start $ids "$poi"
    # shellcheck disable=SC2086
    check "$shell: a missing controller exits with 74" refuses 74 "no USB device controller 'third'" start $ids "$poi" UDC=third
    rm -r "$work/sys/class/udc"
    # shellcheck disable=SC2086
    check "$shell: a machine without a controller gets the advice for a Raspberry Pi" refuses 74 'dr_mode=peripheral' start $ids "$poi"
    check "$shell: a failed start removes the incomplete gadget" half_way
    check "$shell: an unknown command is wrong usage" refuses 2 'COMMAND' restart
done

# The page of the reports lists the descriptor item by item.
page_bytes() {
    sed -nE 's/^\| `([0-9a-f ]+)` \|.*/\1/p' board/poi-gadget/REPORTS.md | tr -s ' \n' ' ' | sed 's/ $//'
}
same_bytes() {
    echo "page: $(page_bytes)"
    [ "$(page_bytes)" = "$("$build/kingyo-poi" descriptor --hex | tr -s ' \n' ' ' | sed 's/ $//')" ]
}
check "the page of the reports lists the bytes of the program's descriptor" same_bytes

# The installation commands of the README, into a folder that replaces /.
installs() (
    local lines
    lines=$(sed -nE 's/^ +sudo (install .*)/\1/p' board/poi-gadget/README.md | sed "s# build/# $build/#")
    mkdir -p "$work/root/usr/local/sbin" "$work/root/etc/systemd/system"
    echo "$lines"
    [ "$(wc -l <<<"$lines")" = 3 ] && bash -euc "$(sed -E "s# /(usr|etc)/# $work/root/\1/#g" <<<"$lines")" &&
        "$work/root/usr/local/sbin/kingyo-poi" descriptor >/dev/null && cd "$work/root" &&
        ls usr/local/sbin/kingyo-poi-gadget etc/kingyo-poi/{poi,gadget}.conf etc/systemd/system/kingyo-poi.service
)
check 'the installation commands of the README work' installs

# The table of fields in the page of the reports, compared with the output of kingyoctl for the same bytes.
page_fields() { # Prints bit offset, bits, usage, logical and physical range.
    awk -F'|' '/^\| 1 \| [0-9]+ \|/ { for (i = 3; i <= 9; i++) gsub(/[ `]/, "", $i)
        print $3, $4, $5, $6, $7, $8, $9 }' board/poi-gadget/REPORTS.md
}
same_fields() {
    "$build/kingyo-poi" descriptor --hex >"$work/poi.hid"
    "$build/kingyoctl" hid describe "$work/poi.hid" | tail -n +2 |
        awk -F'\t' '{ print $4, $5, $11, $12, $13, $14, $15 }' >"$work/read"
    diff "$work/read" <(page_fields) && [ "$(wc -l <"$work/read")" -eq 15 ]
}
check 'the table of fields in the page agrees with kingyoctl' same_fields

# The files that the system of a board reads. The programs of the unit are created, because only
# its text is checked.
if command -v dtc >/dev/null; then
    check 'the overlay compiles' dtc -@ -q -I dts -O dtb -o "$work/poi.dtbo" board/poi-gadget/kingyo-poi.dts
else
    count=$((count + 1))
    echo "ok $count - the overlay compiles # SKIP no dtc (device-tree-compiler)"
fi
unit_is_sound() {
    sed -E "s#/usr/local/sbin/#$work/bin/#" board/poi-gadget/kingyo-poi.service >"$work/kingyo-poi.service"
    printf '#!/bin/sh\n' | tee "$work/bin/kingyo-poi" >"$work/bin/kingyo-poi-gadget"
    chmod +x "$work/bin"/kingyo-poi*
    systemd-analyze verify --man=no "$work/kingyo-poi.service" 2>&1 | grep 'kingyo-poi.service:' && return 1
    return 0
}
if command -v systemd-analyze >/dev/null; then
    check 'systemd-analyze finds no mistake in the unit' unit_is_sound
else
    count=$((count + 1))
    echo "ok $count - systemd finds nothing wrong with the unit # SKIP no systemd-analyze"
fi
echo "1..$count"
