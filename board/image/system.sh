# system.sh -- functions for the root file system of an image that both image.sh and card/card.sh use. Source it after
# lib.sh.
# shellcheck shell=bash disable=SC2154,SC2115  # lib.sh sets the variables

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
