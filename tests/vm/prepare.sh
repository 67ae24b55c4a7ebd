#!/bin/bash
# prepare.sh [IMAGE_KERNEL] -- fetches and builds the files that every test of a guest needs, if they are missing or too
# old. Needs BUILD and GUEST.
#
# The file IMAGE_KERNEL has the release of a disk image's kernel. The test boots the disk with the guest's kernel, which
# must have the same release, because a kernel loads only its own modules. Debian may publish a kernel between the two
# downloads. If the guest's kernel is the older one, the script fetches it again. If the image's kernel is the older
# one, the script prints what to do, and exits with 1.
here=$(dirname "$0") image_kernel=${1:-} cache=${BUILD:-build}/vm/${GUEST:-bookworm}

prepare() {
    local part
    for part in builder root kernel initrd; do
        "$here/$part.sh" || exit 1
    done
}

fits() { # The guest and the image have the same kernel.
    [ -z "$image_kernel" ] || cmp -s "$cache/kernel/release" "$image_kernel"
}

prepare
fits && exit 0
rm -f "$cache/apt/updated"
prepare
fits && exit 0
echo "test-image: the disk image has the kernel $(cat "$image_kernel"), and Debian now has $(cat "$cache/kernel/release");" \
    "please run: rm -r $(dirname "$(dirname "$image_kernel")"), and then the test again" >&2
exit 1
