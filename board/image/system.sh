# system.sh -- functions for the root slots of an image that both image.sh and card/card.sh use. Source it after
# lib.sh.
# shellcheck shell=bash disable=SC2154,SC2115,SC2034,SC1091  # lib.sh sets the variables, and the scripts use them

owner() { # FOLDER: prints the owner of the kiosk's files there, as USER:GROUP.
    sed -n 's/^kingyo:[^:]*:\([0-9]*:[0-9]*\):.*/\1/p' "$1/etc/passwd"
}

# Writes the settings that a cabinet needs beside the kiosk: mounts, keys and services.
settle() { # FOLDER
    local root=$1 unit
    cp -r "$here/root/." "$root/"
    echo kingyo >"$root/etc/hostname"
    : >"$root/etc/machine-id" # Another one at each start: nothing is kept that would need it.
    printf 'PRETTY_NAME="Kingyo %s on %s"\nID=kingyo\nID_LIKE=debian\nVERSION_ID="%s"\n' \
        "$version" "$board" "$version" >"$root/etc/os-release.new"
    mv "$root/etc/os-release.new" "$root/etc/os-release"
    ln -s /usr/lib/systemd/system/kingyo-data.service "$root/etc/systemd/system/multi-user.target.wants/"
    # No user can log in: no console shows a prompt, no user has a password, and there is no network.
    for unit in getty.target getty@.service serial-getty@.service autovt@.service console-getty.service \
        container-getty@.service debug-shell.service emergency.service rescue.service \
        ctrl-alt-del.target systemd-logind.service systemd-networkd.service systemd-networkd.socket \
        systemd-timesyncd.service systemd-ask-password-console.path systemd-ask-password-wall.path \
        proc-sys-fs-binfmt_misc.automount systemd-binfmt.service systemd-update-utmp.service \
        systemd-update-utmp-runlevel.service systemd-machine-id-commit.service apt-daily.timer apt-daily-upgrade.timer dpkg-db-backup.timer fstrim.timer e2scrub_all.timer e2scrub_reap.service; do
        ln -sf /dev/null "$root/etc/systemd/system/$unit"
    done
    sed -i 's/^\([^:]*\):[^:]*:/\1:!:/' "$root/etc/shadow"
    ln -sf multi-user.target "$root/usr/lib/systemd/system/default.target"
    install -d "$root/var/tmp" "$root/var/cache" "$root/var/lib/systemd"
    # Without a data partition, the kiosk finds this folder instead, which it cannot write.
    install -d -m 750 "$root/var/lib/kingyo"
    chown "$(owner "$root")" "$root/var/lib/kingyo"
}

# Removes the tools that install software, because the root partition is read-only.
strip_root() { # FOLDER
    local root=$1
    rm -rf "$root"/usr/share/{doc,man,info,locale,lintian,initramfs-tools,bash-completion,bug} \
        "$root"/var/lib/{apt,dpkg/info} "$root"/var/cache/* "$root"/var/log/* "$root"/boot/* \
        "$root"/etc/{apt,cron.daily,init.d,rc?.d,rcS.d} "$root"/{vmlinuz,initrd.img}*
    # Removes the set-user-id bits, because no user of the image needs them.
    find "$root" -xdev -perm /6000 -type f -exec chmod ug-s {} +
}

# Installs the tools that start, test and replace the system of a root slot (UPDATE.md).
install_updates() { # FOLDER
    local root=$1
    install -d "$root/usr/lib/kingyo"
    install -m 644 "$here/slots/slots.sh" "$root/usr/lib/kingyo/slots.sh"
    install -m 755 "$here/slots/mark-good" "$root/usr/lib/kingyo/mark-good"
    install -m 755 "$here/update/kingyo-update" "$root/usr/lib/kingyo/kingyo-update"
    install -m 644 "$here"/update/{package,drivers}.sh -t "$root/usr/lib/kingyo/"
    printf 'board %s\nversion %s\nname %s\n' "$board" "$update_version" "$update_name" >"$IMAGE/update-version"
    install -m 644 "$IMAGE/update-version" "$root/usr/lib/kingyo/update-version"
    ln -s /etc/systemd/system/kingyo-slot-good.service "$root/etc/systemd/system/multi-user.target.wants/"
    # Without a key the image accepts no update, and the menu has no update page.
    if [ -n "$UPDATE_KEY" ]; then
        install -m 644 "$UPDATE_KEY" "$root/usr/lib/kingyo/update.pub"
        ln -s /etc/systemd/system/kingyo-update.path "$root/etc/systemd/system/multi-user.target.wants/"
        install -d "$root/etc/tmpfiles.d"
        printf 'd /run/kingyo-update 0755 root root -\nf /run/kingyo-update/status 0644 root root - closed\n' \
            >"$root/etc/tmpfiles.d/kingyo-update.conf"
    fi
}

# Makes the system of a root slot, $IMAGE/root.sqfs. The sourcing script defines install_kiosk, and may define settle_board,
# which adds the files of the board.
make_root() {
    local root=$IMAGE/root
    rm -rf --one-file-system "$root"
    mkdir -p "$root"
    tar -x --numeric-owner -C "$root" -f "$cache/root.tar"
    install_kiosk "$root"
    settle "$root"
    ! declare -F settle_board >/dev/null || settle_board "$root"
    install -d "$root/usr/lib/modules" # The initramfs mounts the modules of its kernel here.
    install_updates "$root"
    strip_root "$root"
    # shellcheck disable=SC2086  # $squeeze has several words
    mksquashfs "$root" "$IMAGE/root.sqfs" -comp $squeeze -noappend -no-progress -quiet -mkfs-time "$made_s" -all-time "$made_s" >/dev/null
    kiosk_owner=$(owner "$root")
    rm -rf --one-file-system "$root"
}

# Checks that a root slot has room for a later system that is half as large again. Sizes are in MiB.
check_slot() { # SETTING of image.conf, SIZE of a slot, SIZE of the root
    [ "$2" -ge $(($3 * 3 / 2)) ] || {
        echo "image: the root has $3 MiB and needs slots of $(($3 * 3 / 2)) MiB, but $1 in board/$board/image.conf is $2" >&2
        return 1
    }
}

# Makes the state of a new disk (slots/slots.sh): the system of slot a is good.
make_slots() {
    rm -f "$IMAGE/slots"
    truncate -s 1M "$IMAGE/slots"
    (. "$here/slots/slots.sh" && slots_write "$IMAGE/slots" a - 0)
}

put() { # FILE MIB
    dd if="$1" of="$disk" bs=1M seek="$2" conv=notrunc,sparse status=none
}
