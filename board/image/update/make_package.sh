#!/bin/bash
# make_package.sh ROOT BOARD VERSION NAME KEY TO -- writes the update package of a root file system to the folder TO,
# signed with the secret key KEY of minisign. UPDATE.md describes the files of a package.
set -euo pipefail
root=$1 board=$2 version=$3 name=$4 key=$5 to=$6
chunk=4194304 # As in package.sh.
size=$(stat -c %s "$root")
rm -rf "$to"
mkdir -p "$to"
cp "$root" "$to/root.sqfs"
{
    printf 'kingyo-update 1\nboard %s\nversion %s\nname %s\nsize %s\n' "$board" "$version" "$name" "$size"
    for ((at = 0; at * chunk < size; at++)); do
        dd if="$root" bs="$chunk" skip="$at" count=1 iflag=fullblock status=none | sha256sum | cut -d' ' -f1
    done
} >"$to/manifest"
minisign -S -s "$key" -m "$to/manifest" -x "$to/manifest.minisig" -t "Kingyo $board $version" >"$to.log" || {
    cat "$to.log" >&2
    echo "update: the package could not be signed with $key" >&2
    exit 1
}
rm -f "$to.log"
