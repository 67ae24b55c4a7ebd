#!/bin/bash
# test_doctor_board.sh -- `kingyoctl doctor` on a simulated Raspberry Pi: throttling, the supply
# voltage, the HDMI socket, the overlay of the cabinet and the memory card. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh and doctor.sh set these variables
. "$(dirname "$0")/../lib.sh"
. "$(dirname "$0")/doctor.sh"
gone() { # PART: No finding concerns PART.
    doctor --json "${with[@]}"
    [ "$(sqlite3 :memory: "select count(*) from json_each(readfile('$work/out'), '\$.findings')
        where json_extract(value,'\$.part') = '$1'")" -eq 0 ]
}
firmware=sys/devices/platform/soc/soc:firmware/get_throttled
zone=sys/class/thermal/thermal_zone0
names=proc/device-tree/soc/gpio@7e200000/gpio-line-names

mkdir -p "$root"
check 'a machine that is no Raspberry Pi gives no finding about its supply' gone power
put proc/device-tree/model 'Raspberry Pi 4 Model B Rev 1.5'
printf 'Raspberry Pi 4 Model B Rev 1.5\0' >"$root/proc/device-tree/model"
check 'a model name without a line end is reported' finds fine board model 'Raspberry Pi 4 Model B Rev 1.5' '$'

# ---- Supply voltage and temperature
check 'a kernel that does not measure the supply is named' finds fine power supply 'is unknown to this kernel' '$'
put $firmware 0
check 'a supply without an alarm is fine' finds fine power supply 'is high enough' '$'
check 'a cool processor is fine' finds fine heat processor 'not throttled' '$'
put $firmware 50005
check 'a low voltage is wrong' finds wrong power supply 'too low now' 'use the supply of Raspberry Pi'
check 'a processor that the firmware throttles is reported' finds check heat processor 'slower now' '.*clean the vents'
check 'a processor that is throttled at a low voltage needs a supply first' finds check heat processor 'slower now' 'repair the supply first'
put $firmware 50004
check 'a voltage that was low is also named before the vents' finds check heat processor 'slower now' 'repair the supply first'
put $firmware 4
check 'a processor that is throttled at a good voltage needs no other supply' finds check heat processor 'slower now' 'clean the vents'
put $firmware 50000
check 'a voltage that was low is reported' finds check power supply 'was too low since the start' 'use the supply'
check 'a processor that was throttled is reported' finds check heat processor 'was throttled since the start' 'repair the supply first'
put $firmware 40000
check 'a processor that was throttled at a good voltage needs no other supply' finds check heat processor 'was throttled since the start' 'clean the vents'
put $firmware 80008
check 'a soft limit of temperature is reported' finds check heat processor 'slower now'
check 'a soft limit of temperature says nothing about the supply' finds fine power supply 'is high enough'
for bits in zzz '' '50005 trailing' 5z -1 100000000; do
    put $firmware "$bits"
    check "bits that cannot be read ('$bits') say nothing about the supply" finds fine power supply 'is unknown to this kernel' '$'
done
put $firmware 0x50005
check 'bits with a prefix are read' finds wrong power supply 'too low now'
put $firmware 0
put sys/class/hwmon/hwmon0/name cpu_thermal
put sys/class/hwmon/hwmon0/in0_lcrit_alarm 1
check 'the alarm of another sensor is not the supply' finds fine power supply 'is high enough'
put sys/class/hwmon/hwmon1/name rpi_volt
put sys/class/hwmon/hwmon1/in0_lcrit_alarm 1
rm "$root/$firmware"
check 'a low voltage is reported by the alarm of rpi_volt' finds wrong power supply 'too low now'
put sys/class/hwmon/hwmon1/in0_lcrit_alarm 0
check 'a cleared alarm is fine' finds fine power supply 'is high enough'
put dev/kmsg '3,900,81000000,-;hwmon hwmon1: Undervoltage detected!'
check 'a low voltage in the kernel log is reported' finds check power supply 'was too low since the start'
rm "$root/dev/kmsg"
put $zone/temp 79900
check 'a processor below 80 degrees is fine' finds fine heat processor 'not throttled'
put $zone/temp 80000
check 'a processor at 80 degrees is throttled' finds check heat processor 'slower now'
rm -r "${root:?}/$zone"

# ---- HDMI socket
put sys/class/drm/card1-HDMI-A-1/status connected
put sys/class/drm/card1-HDMI-A-2/status connected
: >"$root/sys/class/drm/card1-HDMI-A-1/edid"
put sys/class/drm/card1-HDMI-A-2/edid EDID
check 'a screen in the second socket only is wrong, also if cmdline.txt forces the first' finds wrong display 'HDMI socket' \
    'HDMI 0 is empty' 'plug the screen into HDMI 0'
put sys/class/drm/card1-HDMI-A-1/edid EDID
right() { ! finds wrong display 'HDMI socket' ''; }
check 'a screen in the first socket is right' right

# ---- Overlay of the cabinet
check 'no line is configured, so no overlay is necessary' gone overlay
with=(--line start=START --line coin=COIN)
check 'a header without names is wrong' finds wrong overlay 'device tree' "has the name '(START|COIN)'" 'add dtoverlay=kingyo-cabinet to config.txt'
mkdir -p "$(dirname "$root/$names")"
printf 'ID_SDA\0START_LAMP\0COIN2\0COIN\0' >"$root/$names"
check 'a name that only begins like another is missing' finds wrong overlay 'device tree' "has the name 'START'"
printf 'ID_SDA\0START_LAMP\0COIN\0START\0' >"$root/$names"
check 'a header with all names needs nothing' gone overlay
mv "$root/proc/device-tree/soc" "$work/soc"
five=proc/device-tree/axi/pcie@1000120000/rp1/gpio@d0000
mkdir -p "$root/$five"
cp "$work/soc/gpio@7e200000/gpio-line-names" "$root/$five/"
check 'the names of a Raspberry Pi 5 are found' gone overlay
rm -r "$root/proc/device-tree/axi"
with=(--line start=pinctrl-bcm2711:17)
check 'a line by chip and offset needs no overlay' gone overlay
with=()

# ---- Memory card
put sys/block/mmcblk0/ro 0
check 'a card is fine, and the unreadable log is named' finds fine card mmcblk0 'only root can read the errors'
put dev/kmsg '6,339,5140900,-;mmcblk0: mmc0:aaaa SC32G 29.7 GiB
 SUBSYSTEM=block'
check 'a card without errors in the kernel log is fine' finds fine card mmcblk0 'no errors in the kernel log'
printf '%s\n' '3,341,91409000,-;I/O error, dev mmcblk0, sector 81 op 0x1:(WRITE)' \
    $'2,342,91409100,-;EXT4-fs error (device mmcblk0p3): ext4_find_entry \e[31m' >>"$root/dev/kmsg"
check 'errors in the kernel log are counted, and the last is printed without control characters' finds wrong card mmcblk0 \
    '2 errors in the kernel log, the last: EXT4-fs error \(device mmcblk0p3\): ext4_find_entry .\[31m' 'copy the takings now'
while read -r line; do
    put dev/kmsg "3,341,91409000,-;$line"
    check "one error of the card: $line" finds wrong card mmcblk0 '1 error in the kernel log, the last: ' 'copy the takings now'
done <<'EOF'
mmc0: error -110 whilst initialising SD card
mmc0: timeout waiting for hardware interrupt
mmc0: Timeout waiting for hardware interrupt.
mmcblk0: failed to send command
EXT4-fs (mmcblk0p4): Remounting filesystem read-only
EOF
while read -r line; do
    put dev/kmsg "$line"
    check "no error of the card: $line" finds fine card mmcblk0 'no errors in the kernel log' '$'
done <<'EOF'
6,339,5140900,-;mmc0: SDHCI controller on fe340000.mmc [fe340000.mmc] using ADMA
6,339,5140900,-;mmcblk0: mmc0:0001 SD32G 29.7 GiB
6,339,5140900,-;EXT4-fs (mmcblk0p2): mounted filesystem ro with ordered data mode
5,339,5140900,-;Kernel command line: root=/dev/mmcblk0p2 rootflags=errors=remount-ro
4,339,5140900,-;brcmfmac mmc1:0001:1: Direct firmware load for brcm/a.clm_blob failed with error -2
3,339,5140900,-;mmc1: error -110 whilst initialising SDIO card
3,339,5140900,-;usb 1-1: device descriptor read error -110
28,339,5140900,-;systemd[1]: Dependency failed for File System Check on /dev/mmcblk0p5
EOF
rm "$root/dev/kmsg"
put sys/block/mmcblk0/device/pre_eol_info 0x02
check 'a worn eMMC is reported' finds check card mmcblk0 'reports that it is worn' 'copy the takings now'
put sys/block/mmcblk0/ro 1
check 'a card that became read-only is wrong' finds wrong card mmcblk0 'is read-only' 'copy the takings now'
mkdir -p "$root/sys/block/mmcblk0boot0"
put sys/block/mmcblk0boot0/ro 1
one() { [ "$(doctor; grep -c '^[^ ]* *card ' "$work/out")" -eq 1 ]; }
check 'the start partitions of an eMMC are no cards' one
rm "$root/sys/block/mmcblk0/ro"
mkfifo "$root/dev/kmsg"
fifo() { timeout 5 "$ctl" doctor --root "$root" --user nobody --data /data >"$work/out"; [ $? -le 1 ]; }
check 'the command ends with a FIFO in place of the log' fifo
echo "1..$count"
