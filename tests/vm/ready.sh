#!/bin/bash
# ready.sh GUEST -- checks whether this machine can run the guest. If not, exits with 1 and prints
# the reason in one line. Exits with 2 if the guest is unknown.
set -u
case ${1:-bookworm} in
    bookworm | trixie) machine=x86_64 ;;
    arm64) machine=aarch64 ;;
    *)
        echo "test-vm: GUEST is bookworm, trixie or arm64, not '$1'" >&2
        exit 2
        ;;
esac
for tool in "qemu-system-$machine" mmdebstrap mksquashfs systemd-sysusers cpio zstd depmod convert; do
    if ! command -v "$tool" >/dev/null; then
        echo "test-vm: skipped: $tool is not installed; board/setup.sh vm installs what is needed" >&2
        exit 1
    fi
done
if [ "$(id -u)" -ne 0 ]; then
    echo 'test-vm: skipped: making a root file system needs root; please run: sudo make test-vm' >&2
    exit 1
fi
