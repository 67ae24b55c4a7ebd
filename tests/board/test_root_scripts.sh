#!/bin/bash
# test_root_scripts.sh -- every script that runs as root, in folders that another user filled with
# links, FIFOs and hostile names. The scripts write and remove nothing outside these folders, and
# never block. test_check_data.sh tests the scripts of the data folder. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
cd "$(dirname "$0")/../.." || exit 1
precious=$work/precious bin=$work/bin
mkdir "$bin"
untouched() { [ "$(cat "$precious/file")" = precious ] && [ "$(ls -A "$precious")" = file ] && [ ! -e "$work/owned" ]; }
fresh() { rm -rf "$precious" && mkdir "$precious" && echo precious >"$precious/file"; }

# ---- Maintainer scripts of the packages
tools=(deb-systemd-helper deb-systemd-invoke systemctl systemd-tmpfiles systemd-sysusers udevadm)
for tool in "${tools[@]}"; do
    printf '#!/bin/sh\necho "%s $*" >>"%s"\n' "$tool" "$work/calls" >"$bin/$tool"
    chmod +x "$bin/$tool"
done
fill() { # FOLDER: Fills the folder with hostile files, as the service user could.
    mkdir -p "$1/deep" && ln -s "$precious" "$1/link" && ln -s "$precious/file" "$1/deep/link" && mkfifo "$1/fifo" &&
        ln -s "$work/owned" "$1/to-nothing" && touch "$1/"$'-rf\n..' "$1/\$(touch owned)" && mknod "$1/zero" c 1 5
}
maintains() { # SCRIPT WORDS...: Runs the script with its own /var/cache and /var/lib, both hostile.
    fresh
    : >"$work/calls"
    PATH=$bin:$PATH timeout 20 unshare -m bash -c "$(declare -f fill)
        precious=$precious work=$work
        mount -t tmpfs none /var/cache && mount -t tmpfs none /var/lib && fill /var/cache/kingyo && fill /var/lib/kingyo &&
        sh $(printf '%q ' "$@") && [ -p /var/lib/kingyo/fifo ] && ls /var/lib/kingyo/deep/link && ls -A /var/cache" || return 1
    untouched
}
scripts=(board/deb/*.postinst board/deb/*.prerm board/deb/*.postrm)
if [ "$(id -u)" -eq 0 ] && unshare -m true 2>/dev/null; then
    for script in "${scripts[@]}"; do
        for words in configure 'configure 0.1' remove purge upgrade abort-remove; do
            # shellcheck disable=SC2086  # several arguments
            check "${script##*/} $words changes nothing outside its folders" maintains "$script" $words
        done
    done
    purged() { maintains board/deb/kingyo-kiosk.postrm purge && ! grep -q '^kingyo$' "$work/check.log"; }
    check 'a purge removes the cache and follows no link' purged
else
    skip 'the maintainer scripts change nothing outside their folders' 'no root, or no mounts'
fi
writes_little() { # The only file command in these scripts is one rm.
    ! grep -nE '(^|[^-a-z])(cp|mv|chown|chmod|ln|tee|touch|mkdir|install|cat)([^-a-z]|$)|[^2&>]>[^/&]' "${scripts[@]}" | grep -vE '^[^:]*:[0-9]+:#' &&
        [ "$(grep -hE '(^|[^-a-z])rm ' "${scripts[@]}")" = '    rm -rf /var/cache/kingyo' ]
}
check 'the maintainer scripts write no file' writes_little

# ---- tmpfiles and sysusers: the tools of systemd; no line refers to a name inside the folders of the service user
flat() { ! grep -vE '^(#|$|d /var/(lib|cache)/kingyo [0-9]{4} kingyo kingyo (-|60d)$)' board/tmpfiles/kingyo.conf; }
check 'tmpfiles creates the two folders and no name inside them' flat
no_other_user() { ! grep -vE '^(#|$|u kingyo - "[^"]*" /var/lib/kingyo$|m kingyo [a-z]+$)' board/sysusers/kingyo.conf; }
check 'sysusers creates a user without a shell' no_other_user

# ---- make install
# COMMAND...: The command creates a hostile file at $to; then make install and make uninstall run.
installs() {
    fresh
    local root=$work/root to=$work/root$1
    rm -rf "$root"
    mkdir -p "$(dirname "$to")"
    "${@:2}" "$to" && BUILD=$build DESTDIR=$root PREFIX=/usr timeout 60 board/install.sh install && untouched || return 1
    BUILD=$build DESTDIR=$root PREFIX=/usr timeout 60 board/install.sh uninstall && untouched
}
for to in /usr/lib/systemd/system/kingyo.service /usr/lib/kingyo/check-data /usr/bin/kingyoctl; do
    check "make install replaces a link at $to" installs $to ln -s "$precious/file"
    check "make install replaces a dangling link at $to" installs $to ln -s "$work/owned"
    check "make install replaces a FIFO at $to" installs $to mkfifo
done
check "make install keeps an operator's link for kingyo.conf" installs /etc/kingyo/kingyo.conf ln -s "$precious/file"
check "make uninstall keeps an operator's link for kingyo.conf" test -L "$work/root/etc/kingyo/kingyo.conf"
check 'a FIFO for kingyo.conf blocks neither install nor uninstall' installs /etc/kingyo/kingyo.conf mkfifo

# ---- udev: the rules run no program as root
no_helpers() { ! grep -nE 'RUN|PROGRAM|IMPORT|OWNER|SYMLINK' board/udev/*.rules board/image/root/etc/udev/rules.d/*.rules; }
check 'no udev rule runs a program' no_helpers

# ---- The gadget of the poi
gadget() { # CODE PATTERN: Runs with the configuration $conf.
    KINGYO_POI_GADGET_CONF=$conf CONFIGFS=$work/configfs SYSFS=$work/sys timeout 10 sh board/poi-gadget/kingyo-poi-gadget start >"$work/out" 2>&1
    local code=$?
    cat "$work/out"
    [ $code -eq "$1" ] && grep -q "$2" "$work/out" && [ ! -e "$work/owned" ]
}
conf=$work/gadget.conf
mkfifo "$conf"
check 'the gadget refuses a FIFO as its configuration' gadget 65 'no regular file'
rm "$conf" && mkdir "$conf"
check 'the gadget refuses a folder as its configuration' gadget 65 'no regular file'
rmdir "$conf" && printf 'VENDOR=$(touch %s)\nPRODUCT=0x0001\n' "$work/owned" >"$conf"
check 'a value of the configuration is not executed' gadget 2 'is not 0x and four'
printf 'PATH=%s\n' "$bin" >"$conf"
check 'an unknown name in the configuration is refused' gadget 65 'is no setting'
sandboxed() { grep -q '^ProtectSystem=strict' board/poi-gadget/kingyo-poi.service && grep -q '^NoNewPrivileges=yes' board/poi-gadget/kingyo-poi.service; }
check 'the service of the poi writes nothing below /' sandboxed

# ---- The image: root works in a folder of BUILD
makes() { # CODE: Sources lib.sh as image.sh, root.sh and boot.sh do.
    (BUILD=$work/build bash -c '. board/image/lib.sh vm' vm) >"$work/out" 2>&1
    local code=$?
    cat "$work/out"
    [ $code -eq "$1" ]
}
check "the image is made in a folder of one's own" makes 0
chmod 1777 "$work/build/image"
check 'the image is not made in a folder that others may write' makes 1
check 'the error names a folder that others may write' grep -q 'other users may write there' "$work/out"
chmod 755 "$work/build/image"
if [ "$(id -u)" -eq 0 ]; then
    chown 65534 "$work/build/image"
    check 'the image is not made in a folder of another user' makes 1
else
    skip 'the image is not made in a folder of another user' 'no root'
fi
# ---- Packages for another processor: root makes a root file system in a folder of BUILD
crosses() { # CODE: ARCH=none has no emulator, so that a folder that is not refused gives exit code 2.
    BUILD=$work/build board/deb/cross.sh none deb >"$work/out" 2>&1
    local code=$?
    cat "$work/out"
    [ $code -eq "$1" ]
}
check 'packages for another processor are made in a private folder' crosses 2
chmod 1777 "$work/build/cross"
check 'the packages are not made in a folder that others may write' crosses 1
check 'the error names that folder' grep -q 'build/cross: other users may write there' "$work/out"
rm -rf "$work/build/cross" && ln -s "$precious" "$work/build/cross" && chmod 1777 "$precious"
check 'a link to such a folder is refused too' crosses 1
own_names() { ! grep -nE '[^-a-z]/tmp/|[^-a-z]/var/tmp/' board/image/*.sh board/setup.sh board/deb/*.sh; }
check 'no script writes a fixed name into /tmp' own_names
echo "1..$count"
