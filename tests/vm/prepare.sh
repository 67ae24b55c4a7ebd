#!/bin/bash
# prepare.sh -- fetches and builds the files that every test of a guest needs, if they are missing
# or too old.
here=$(dirname "$0")
for part in builder root kernel initrd; do
    "$here/$part.sh" || exit 1
done
