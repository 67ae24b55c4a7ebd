#!/bin/bash
# pi_os.sh rpi5|rpi4 -- runs the commands of the cabinet's page (board/cabinet/README.md) in a root of Debian 13 for arm64,
# as a person runs them on Raspberry Pi OS, and checks what they leave behind.
#
# The commands are read from the page. Programs of the root run by qemu's emulation of user programs. The root has no
# kernel, no firmware, no card and no raspi-config. Therefore `mount`, `raspi-config`, `systemctl stop` and
# `systemctl daemon-reload` only record their arguments, and the commands that change a card in another computer run on files.
#
# The packages are those of `make deb ARCH=arm64`. Needs root, mmdebstrap and this machine's mirror. Speaks TAP.
set -u
board=${1:-rpi5}
cd "$(dirname "$0")/../.." || exit 1
page=board/cabinet/README.md
board/deb/emulate.sh arm64 || exit 1
. tests/fresh/root.sh
make_root pi-os trixie arm64 "sudo,device-tree-compiler,$libraries" || exit 1

inside() { # COMMAND...: runs in the user's folder of the root, with programs that record their arguments first in the path
    chroot "$root" env -C /home/pi DEBIAN_FRONTEND=noninteractive PATH=/home/recorders:/usr/sbin:/usr/bin LC_ALL=C.UTF-8 "$@"
}
# Prints the commands of step NUMBER of a section: lines that are indented by seven columns.
commands() { # SECTION NUMBER
    awk -v section="## $1" -v number="$2" '
        /^## / { inside = ($0 == section) }
        inside && /^[0-9]+\. / { step = $1 + 0 }
        inside && step == number && /^       / { print substr($0, 8) }' "$page" | sed "s,^cd rpi5,cd $board,"
}
runs() { # SECTION NUMBER: runs the commands of a step. The shell stays in its folder, as a person does.
    commands "$1" "$2" >"$root/home/pi/step"
    [ -s "$root/home/pi/step" ] || { echo "the page has no commands for step $2"; return 1; }
    cat "$root/home/pi/step"
    printf 'cd %s\nset -e\n. /home/pi/step\npwd >/home/pi/folder\n' "$(cat "$root/home/pi/folder")" >"$root/home/pi/run"
    inside sh /home/pi/run
}

# ---- A board after the first start of Raspberry Pi OS

prepare() {
    local program
    mkdir -p "$root/home/pi" "$root/home/recorders" "$root/boot/firmware/overlays"
    cp "$build"/deb/kingyo_*_arm64.deb "$build"/deb/kingyo-kiosk_*_all.deb "$root/home/pi/"
    cp -r "board/$board" board/cabinet "$root/home/pi/"
    for program in mount raspi-config; do
        printf '#!/bin/sh\necho "%s $*" >>/home/pi/recorded\n' $program >"$root/home/recorders/$program"
    done
    # systemd does not run here, so it cannot stop a service or read its units again.
    printf '#!/bin/sh\ncase $1 in stop | daemon-reload) echo "systemctl $*" >>/home/pi/recorded ;; *) exec /usr/bin/systemctl "$@" ;; esac\n' \
        >"$root/home/recorders/systemctl"
    echo "127.0.0.1 localhost $(hostname)" >"$root/etc/hosts"
    # sudo sets its own path. Root may use it without a password.
    printf 'Defaults secure_path="/home/recorders:/usr/sbin:/usr/bin"\n' >"$root/etc/sudoers.d/path"
    chmod 755 "$root"/home/recorders/*
    chmod 440 "$root/etc/sudoers.d/path"
    echo 'APT::Get::Assume-Yes "true";' >"$root/etc/apt/apt.conf.d/90-test"
    printf '# For more options see the documentation\ndtparam=audio=on\ndtoverlay=vc4-kms-v3d\ndisable_overscan=1\n[cm5]\ndtoverlay=dwc2,dr_mode=host\n\n[all]\n' \
        >"$root/boot/firmware/config.txt"
    echo 'console=serial0,115200 console=tty1 root=PARTUUID=0123abcd-02 rootfstype=ext4 fsck.repair=yes rootwait' >"$root/boot/firmware/cmdline.txt"
    echo 'proc /proc proc defaults 0 0' >"$root/etc/fstab"
    echo /home/pi >"$root/home/pi/folder"
    mkdir -p "$root/dev" && for program in null:3 zero:5 random:8 urandom:9; do
        [ -e "$root/dev/${program%:*}" ] || mknod -m 666 "$root/dev/${program%:*}" c 1 "${program#*:}"
    done
}
check 'a root like Raspberry Pi OS is prepared' prepare

check 'the packages can be installed with apt' runs Setup 2
check 'the overlay can be compiled' runs Setup 3
named() { # The overlay is applied to a tree with a node that has the label of the header, and names its lines.
    printf '/dts-v1/;\n/ { compatible = "brcm,bcm2712"; gpio: gpio { }; };\n' | dtc -q -@ -I dts -O dtb -o "$work/base" - &&
        fdtoverlay -i "$work/base" -o "$work/tree" "$root/boot/firmware/overlays/kingyo-cabinet.dtbo" &&
        fdtget "$work/tree" /gpio gpio-line-names | grep -w START_LAMP
}
check 'the overlay names the lines of the header' named
check 'the settings of the firmware can be appended' runs Setup 4
once() { # FILE: no line occurs twice. Only sections may.
    ! grep -v '^\[\|^$' "$1" | sort | uniq -d | grep .
}
check 'config.txt has no line twice' once "$root/boot/firmware/config.txt"
has_all() { # Each setting of the board is in the section for all boards.
    local line
    while read -r line; do
        case $line in '#'* | '') continue ;; esac
        awk -v line="$line" '/^\[/ { all = ($0 == "[all]") } NR == 1 { all = 1 } all && $0 == line { found = 1 } END { exit !found }' \
            "$root/boot/firmware/config.txt" || { echo "missing: $line"; return 1; }
    done <"board/$board/config.txt"
}
check 'config.txt has each setting of the board' has_all
one_line() {
    [ "$(wc -l <"$root/boot/firmware/cmdline.txt")" = 1 ] && grep -q "^console=serial0.* rootwait $(cat "board/$board/cmdline.txt")$" "$root/boot/firmware/cmdline.txt"
}
check 'cmdline.txt is one line with the words of the board at its end' one_line
check 'the lines of the cabinet can be appended' runs Setup 5
check 'the kiosk accepts its settings' inside kingyoctl config check /etc/kingyo/kingyo.conf
enabled() { inside systemctl is-enabled "$@"; }
check 'the kiosk starts at power on' enabled kingyo.service
user_groups() { inside id -nG kingyo | tr ' ' '\n' | grep -x "$1"; }
check 'the user of the kiosk may use the screen' user_groups video

# ---- The read-only root

echo /home/pi >"$root/home/pi/folder"
check 'the data partition can be set up' runs 'A read-only root' 2
valid() { inside findmnt --verify --tab-file /etc/fstab 2>&1 | tee "$work/verified"; grep '^0 parse errors' "$work/verified"; }
check 'fstab can be parsed' valid
mounted() { # The kiosk is stopped before, so that it writes nothing below the mount.
    grep -v daemon-reload "$root/home/pi/recorded" | head -2 | paste -s -d , | grep -x 'systemctl stop kingyo,mount /var/lib/kingyo' &&
        [ "$(inside stat -c %U:%G /var/lib/kingyo)" = kingyo:kingyo ]
}
check 'the partition is mounted, and belongs to the kiosk' mounted
check 'the check of the data starts at power on' enabled kingyo-data.service
check 'the kiosk can be set to start without the partition' runs 'A read-only root' 3
in_force() { # The last lines of the unit and its drop-ins: the kiosk has no state folder, so no mount is required.
    inside systemd-analyze cat-config systemd/system/kingyo.service >"$work/unit" && grep -x '^Type=notify' "$work/unit" &&
        [ "$(grep '^StateDirectory=' "$work/unit" | tail -1)" = StateDirectory= ] && grep -x 'ReadWritePaths=-/var/lib/kingyo' "$work/unit"
}
check 'the drop-in belongs to the unit of the kiosk' in_force
check 'the root can be made read-only' runs 'A read-only root' 4
overlay() { [ "$(grep -c '^raspi-config nonint enable_' "$root/home/pi/recorded")" = 2 ]; }
check 'raspi-config is asked for the two steps' overlay

# ---- The card in another computer

# The table is in one file, and each file system in another, because this machine may have no devices for partitions.
size_of() { sfdisk -d "$work/sdX" | sed -n "s/.*sdX$1 :.* size= *\([0-9]*\),.*/\1/p"; }
card_steps() {
    truncate -s 16G "$work/sdX"
    printf 'label: dos\nstart=4M, size=512M, type=c\nstart=516M, type=83\n' | sfdisk -q "$work/sdX"
    truncate -s $(($(size_of 2) * 512)) "$work/sdX2" && mkfs.ext4 -q "$work/sdX2"
    commands 'A read-only root' 1 | sed "s,/dev/,$work/,g; s/^sudo //; s/| sudo /| /; s/^mkfs/truncate -s 8G ${work//\//\\/}\/sdX3; mkfs/" >"$work/steps"
    cat "$work/steps"
    (cd "$work" && bash -e "$work/steps")
}
check 'the commands for the card in another computer run' card_steps
fits() { # The file system fits into the smaller partition, and is valid.
    local blocks
    blocks=$(dumpe2fs -h "$work/sdX2" 2>/dev/null | sed -n 's/^Block count: *//p')
    [ $((blocks * 8)) -le "$(size_of 2)" ] && e2fsck -fn "$work/sdX2"
}
check 'the root file system fits into its partition' fits
check 'the data partition has the rest of the card' test "$(size_of 3)" -gt 15000000
labeled() { [ "$(blkid -s LABEL -o value "$work/sdX3")" = kingyo-data ]; }
check 'the data partition has the label of fstab' labeled
echo "1..$count"
exit $failed
