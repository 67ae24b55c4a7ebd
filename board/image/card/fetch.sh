#!/bin/bash
# fetch.sh BOARD -- downloads Debian's packages for the image to $cache/debs, and lists them in $cache/packages.list.
#
# packages.list has one line for each package: name, version, SHA-256. Two builds from the files of one list give the same
# image. $cache/debs is also an archive for apt, so that no later step asks a mirror. A download is used for a week.
# Exit code 1: the packages are not available, and there is no earlier download; one line says why.
# shellcheck disable=SC2154,SC1091,SC2115  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
. "$here/card/lib.sh"

apt_folder=$cache/apt
new=$cache/debs.new
made_of="$suite $arch $kernel $(root_packages) $boot_packages"
is_fresh "$cache/packages.list" "$made_of" && exit 0

# Writes a configuration of apt for the image's release and processor, separate from this machine's own.
configure_apt() {
    rm -rf "$apt_folder"
    mkdir -p "$apt_folder"/{lists,archives}/partial
    COMPONENTS=$components "$top/board/debian_sources.sh" "$suite" image >"$apt_folder/sources.list"
    : >"$apt_folder/status"
    cat >"$apt_folder/apt.conf" <<END
Dir::State "$apt_folder"; Dir::State::lists "$apt_folder/lists"; Dir::State::status "$apt_folder/status";
Dir::Cache "$apt_folder"; Dir::Etc::sourcelist "$apt_folder/sources.list"; Dir::Etc::sourceparts "-";
APT::Architecture "$arch"; APT::Architectures { "$arch"; }; APT::Sandbox::User "root";
APT::Install-Recommends "false"; Debug::NoLocking "true";
END
    export APT_CONFIG=$apt_folder/apt.conf
    apt-get -qq update
}

# Downloads the packages of the root with their dependencies, and those that are unpacked beside it.
download() {
    local linux
    linux=$(apt-cache depends "$kernel" | sed -n 's/.*Depends: \(linux-image-[^ ]*\)$/\1/p' | head -1)
    rm -rf "$new"
    mkdir -p "$new"
    # shellcheck disable=SC2046
    apt-get -qq -y --download-only install '?essential' $(root_packages | tr , ' ') &&
        mv "$apt_folder"/archives/*.deb "$new/" || return 1
    # shellcheck disable=SC2086
    (cd "$new" && apt-get -qq download "$linux" $boot_packages)
}

# Writes the two files of an archive that apt reads, and the list of the packages. mmdebstrap asks for the release's name.
index() {
    (cd "$new" && dpkg-scanpackages --multiversion . /dev/null >Packages) || return 1
    printf 'Suite: %s\nCodename: %s\nSHA256:\n %s %s Packages\n' "$suite" "$suite" \
        "$(sha256sum "$new/Packages" | cut -d' ' -f1)" "$(stat -c %s "$new/Packages")" >"$new/Release"
    awk '$1 == "Package:" { name = $2 } $1 == "Version:" { version = $2 } $1 == "SHA256:" { print name, version, $2 }' \
        "$new/Packages" | LC_ALL=C sort >"$cache/packages.list.new"
    [ -s "$cache/packages.list.new" ]
}

step "downloads Debian's packages: $suite, $arch"
{ configure_apt && download && index; } >"$cache/fetch.log" 2>&1 || {
    why=$(grep -E '^(E|W|image): ' "$cache/fetch.log" | head -1)
    why="Debian's packages are not available: ${why:-$(tail -1 "$cache/fetch.log")} (see $cache/fetch.log)"
    if [ "$(cat "$cache/packages.list.of" 2>/dev/null)" = "$made_of" ]; then
        echo "image: $why; the download of $(date -r "$cache/packages.list" +%F) is used again" >&2
        exit 0
    fi
    echo "image: $why" >&2
    exit 1
}
rm -rf "$cache/debs" "$apt_folder"
mv "$new" "$cache/debs"
mv "$cache/packages.list.new" "$cache/packages.list"
echo "$made_of" >"$cache/packages.list.of"
