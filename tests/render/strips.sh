#!/bin/bash
# strips.sh BUILD FOLDER -- draws ten frames of each moment of strips.txt, side by side in two rows, to FOLDER/NAME.png.
set -eu
here=$(dirname "$0")
mkdir -p "$2"
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT
while read -r name options; do
    [[ $name == \#* || -z $name ]] && continue
    # shellcheck disable=SC2086
    "$1/tests/render/shot" --mode festival --players 4 --start --size 480x300 --frames 10 $options -o "$frames/" >/dev/null
    convert \( "$frames"/[0-4].png +append \) \( "$frames"/[5-9].png +append \) -append "$2/$name.png"
    echo "$2/$name.png"
done <"$here/strips.txt"
