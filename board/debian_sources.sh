#!/bin/bash
# debian_sources.sh RELEASE PROGRAM -- prints apt's source lines of a Debian release, with the addresses that apt of this
# machine uses. COMPONENTS names the components (default: main). Exits with 1 and one line of PROGRAM if apt has no package lists of Debian.
set -eu
find_address() { # 1|0: Prints the address of the security updates (1) or of the archive (0).
    # shellcheck disable=SC2016  # apt-get replaces these names, not the shell.
    apt-get indextargets --format '$(REPO_URI) $(ORIGIN) $(LABEL)' 'Created-By: Packages' 2>/dev/null |
        awk -v is_security="$1" '$2 == "Debian" && (($3 ~ /Security/) == is_security) { print $1; exit }'
}
archive=$(find_address 0)
if [ -z "$archive" ]; then
    echo "$2: apt on this machine has no package lists of Debian; run apt-get update first" >&2
    exit 1
fi
echo "deb $archive $1 ${COMPONENTS:-main}"
security=$(find_address 1)
[ -z "$security" ] || echo "deb $security $1-security ${COMPONENTS:-main}"
