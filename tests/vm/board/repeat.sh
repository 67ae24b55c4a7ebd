#!/bin/bash
# repeat.sh BOARD -- builds the image of BOARD a second time from the same downloaded packages and the same packages of this
# tree, and compares the two images bit for bit. The first image must be of the newest commit, whose time is the date of
# all files in an image. Exit code 0: they are equal.
# shellcheck disable=SC1090,SC2154  # image.conf sets these variables
set -eu
board=${1:?usage: repeat.sh BOARD}
BUILD=${BUILD:-build}
top=$(cd "$(dirname "$0")/../../.." && pwd)
BUILD=$(cd "$BUILD" && pwd)
again=$BUILD/again
cache=$(cd "$top" && . "board/$board/image.conf" 2>/dev/null && echo "image/$suite-$arch")
rm -rf --one-file-system "$again"
mkdir -p "$again/$cache"
[ ! -d "$BUILD/deb" ] || cp -rp "$BUILD/deb" "$again/"
cp -rp "$BUILD/$cache/debs" "$BUILD/$cache"/packages.list* "$again/$cache/"
[ ! -d "$BUILD/cross" ] || ln -s "$BUILD/cross" "$again/cross"
# The compression of equal files is left out.
BUILD=$again IMAGE='' COMPRESS=no "$top/board/image/card/card.sh" "$board"
cmp "$BUILD/image/$board/kingyo.img" "$again/image/$board/kingyo.img"
sha256sum "$BUILD/image/$board"/kingyo.img "$again/image/$board"/kingyo.img
rm -rf --one-file-system "$again"
echo "the two images of $board are equal"
