#!/bin/bash
# prepare.sh -- what every test of a guest needs, fetched and built where it is not there or too old.
here=$(dirname "$0")
for part in builder root kernel initrd; do
    "$here/$part.sh" || exit 1
done
