#!/bin/bash
# test_prepare_guest.sh -- tests/vm/prepare.sh fetches the guest's kernel again if a disk image has a newer one. Stubs
# replace the scripts that download. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
root=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$work/vm" "$work/build/vm/bookworm/"{apt,kernel}
cp "$root/tests/vm/prepare.sh" "$work/vm/"
for part in builder root initrd; do
    printf '#!/bin/sh\necho %s >>%s/calls\n' $part "$work" >"$work/vm/$part.sh"
done
# The stub of kernel.sh reads the package list again only without the mark of apt, as guest_apt of lib.sh does.
cat >"$work/vm/kernel.sh" <<END
#!/bin/sh
[ -f $work/build/vm/bookworm/apt/updated ] || cp $work/debian $work/build/vm/bookworm/kernel/release
touch $work/build/vm/bookworm/apt/updated
END
chmod +x "$work"/vm/*.sh

prepared() { # [IMAGE_KERNEL]
    BUILD=$work/build GUEST=bookworm "$work/vm/prepare.sh" "$@" >"$work/out" 2>"$work/err"
}
has_kernel() { # RELEASE
    [ "$(cat "$work/build/vm/bookworm/kernel/release")" = "$1" ]
}

echo 6.1.0-56 >"$work/debian"
check 'without an image, the files are prepared once' prepared
check 'the guest has the kernel of that day' has_kernel 6.1.0-56
echo 6.1.0-57 | tee "$work/debian" >"$work/image"
check 'without an image, an older kernel remains' prepared
check 'it remains the older one' has_kernel 6.1.0-56
check 'an image with a newer kernel: the files are prepared' prepared "$work/image"
check 'the guest has the kernel of the image' has_kernel 6.1.0-57
echo 6.1.0-58 >"$work/debian"
check 'an image with the same kernel: nothing is fetched' prepared "$work/image"
check 'the kernel is the same' has_kernel 6.1.0-57
echo 6.1.0-56 >"$work/image"
is_refused() {
    ! prepared "$work/image" && [ "$(wc -l <"$work/err")" -eq 1 ] && grep -q 'the kernel 6.1.0-56, and Debian now has 6.1.0-58' "$work/err"
}
check 'an image with a kernel that Debian no longer has: one line and code 1' is_refused
echo 'exit 1' >"$work/vm/root.sh"
fails() { ! prepared; }
check 'a part that fails ends the script' fails
echo "1..$count"
