#!/bin/bash
# columns.sh -- no line of C is over 100 columns: two files stand side by side on one screen.
#
# Counts characters, not bytes. One line per breach; exit 1 on any.
set -u
git ls-files -co --exclude-standard '*.[ch]' | LC_ALL=C.UTF-8 xargs grep -nE '^.{101,}' /dev/null | cut -c1-120
[ "${PIPESTATUS[1]}" -ne 0 ] # xargs says 123 when grep found nothing, 0 when it did.
