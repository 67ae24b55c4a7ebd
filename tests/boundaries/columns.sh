#!/bin/bash
# columns.sh -- checks that no line of C has more than 100 columns, so that two files fit side by
# side on a screen.
# Counts characters, not bytes. Prints one line for each breach and exits with 1 if there is any.
set -u
git ls-files -co --exclude-standard '*.[ch]' | LC_ALL=C.UTF-8 xargs grep -nE '^.{101,}' /dev/null | cut -c1-120
[ "${PIPESTATUS[1]}" -ne 0 ] # xargs returns 123 if grep found nothing, and 0 if grep found a line.
