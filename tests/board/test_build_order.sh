#!/bin/bash
# test_build_order.sh -- a package that comes or goes between two commands: what depends on it is compiled again, and
# nothing else. A compiler of the test's own hides assimp's headers. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets them
. "$(dirname "$0")/../lib.sh"
tree=$work/build
flat=$tree/platform/ctl/import/import_flat.o core=$tree/core/base/rng.o
mkdir "$tree" "$work/include" "$work/pc" "$work/bin"
# What was baked is the same whatever the compiler: it is copied, so that the test takes seconds.
cp -a "$build"/{generated,assets,bake_host,bake,bake_species,bake_words} "$tree/"
rm -f "$tree"/generated/*.o
ln -s /usr/include/* "$work/include/"
rm -f "$work/include/assimp"
multiarch=$(gcc -print-multiarch)
cat >"$work/bin/hidden-gcc" <<END
#!/bin/sh
exec gcc -nostdinc -isystem "$(gcc -print-file-name=include)" -isystem "$work/include/$multiarch" -isystem "$work/include" "\$@"
END
chmod +x "$work/bin/hidden-gcc"

builds() { # WORDS...: the number of objects that are compiled.
    make BUILD="$tree" CC="$work/bin/hidden-gcc" "$flat" "$core" "$@" >"$work/out" 2>&1 || { cat "$work/out"; return 1; }
    cat "$work/out"
    compiled=$(grep -c '^  CC    \(platform\|core/base\)' "$work/out") || true
}
reads_assimp() { grep -q aiImportFile "$flat"; }
starts_without() { builds && [ "$compiled" -eq 2 ] && ! reads_assimp && grep -qx 'assimp no' "$tree/found.txt"; }
is_still() { builds && [ "$compiled" -eq 0 ]; }
comes() { mkdir "$work/include/assimp" && cp -r /usr/include/assimp/* "$work/include/assimp/" && builds && [ "$compiled" -eq 1 ] && reads_assimp; }
goes() { rm -r "$work/include/assimp" && builds && [ "$compiled" -eq 1 ] && ! reads_assimp; }
flags_change() { builds OPT=-O1 && [ "$compiled" -eq 2 ]; }
gpiod_changes() { # As pkg-config of another release answers: objects and the choice of sources follow.
    printf 'Name: libgpiod\nDescription: none\nVersion: 2.1\nLibs: -lgpiod\nCflags:\n' >"$work/pc/libgpiod.pc"
    PKG_CONFIG_PATH=$work/pc builds OPT=-O1 && [ "$compiled" -eq 1 ] &&
        grep -qx 'libgpiod major version 2' "$tree/found.txt" &&
        PKG_CONFIG_PATH=$work/pc make -n BUILD="$tree" CC="$work/bin/hidden-gcc" OPT=-O1 "$tree/shell.a" >"$work/out" 2>&1 &&
        grep -q 'gpio_lines2' "$work/out" && ! grep -q 'gpio_lines1' "$work/out"
}

echo 1..7
if [ -d /usr/include/assimp ]; then
    check 'without assimp, no object reads it' starts_without
    check 'a second build compiles nothing' is_still
    check 'assimp comes: what reads it is compiled again, the core is not' comes
    check 'then nothing is compiled' is_still
    check 'assimp goes: what read it is compiled again' goes
else
    for _ in 1 2 3 4 5; do skip 'assimp comes and goes' 'libassimp-dev is not installed'; done
    builds
fi
check 'other flags compile everything again' flags_change
check 'another libgpiod compiles the shell again, with its own sources' gpiod_changes
