#!/bin/bash
# emulate.sh ARCH -- lets this machine run programs for ARCH (arm64 or armhf): registers qemu's emulator of user programs in the
# kernel, if no service of the machine has done so. Needs root. Exits with 2 if ARCH has no emulator.
set -eu
case ${1:-} in
arm64) emulator=qemu-aarch64 ;;
armhf) emulator=qemu-arm ;;
*) echo "ARCH=${1:-}: expected arm64 or armhf" >&2; exit 2 ;;
esac
if [ "$(id -u)" -ne 0 ]; then
    echo "a program for $1 runs in a root file system, which needs root; please run the same command with sudo" >&2
    exit 1
fi
formats=/proc/sys/fs/binfmt_misc
[ -e $formats/register ] || mount -t binfmt_misc binfmt_misc $formats
[ -e "$formats/$emulator" ] || cat "/usr/lib/binfmt.d/$emulator.conf" >$formats/register
