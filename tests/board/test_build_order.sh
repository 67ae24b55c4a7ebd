#!/bin/bash
# test_build_order.sh -- after a package was installed or removed, the build compiles the objects
# that depend on the package and no other object. A wrapper of the compiler hides the headers of
# assimp. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
tree=$work/build
flat=$tree/platform/ctl/import/import_flat.o core=$tree/core/base/rng.o
mkdir "$tree" "$work/include" "$work/pc" "$work/bin"
# The baked files do not depend on the compiler. They are copied so that the test takes seconds.
cp -a "$build"/{generated,assets,bake_host,bake,bake_species} "$tree/"
rm -f "$tree"/generated/*.o
ln -s /usr/include/* "$work/include/"
rm -f "$work/include/assimp"
multiarch=$(gcc -print-multiarch)
cat >"$work/bin/hidden-gcc" <<END
#!/bin/sh
exec gcc -nostdinc -isystem "$(gcc -print-file-name=include)" -isystem "$work/include/$multiarch" -isystem "$work/include" "\$@"
END
chmod +x "$work/bin/hidden-gcc"

builds() { # WORDS...: Prints the number of compiled objects.
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
# pkg-config answers as in another release. Both the objects and the choice of sources must follow.
gpiod_changes() {
    printf 'Name: libgpiod\nDescription: none\nVersion: 2.1\nLibs: -lgpiod\nCflags:\n' >"$work/pc/libgpiod.pc"
    PKG_CONFIG_PATH=$work/pc builds OPT=-O1 && [ "$compiled" -eq 1 ] &&
        grep -qx 'libgpiod major version 2' "$tree/found.txt" &&
        PKG_CONFIG_PATH=$work/pc make -n BUILD="$tree" CC="$work/bin/hidden-gcc" OPT=-O1 "$tree/shell.a" >"$work/out" 2>&1 &&
        grep -q 'gpio_lines2' "$work/out" && ! grep -q 'gpio_lines1' "$work/out"
}

# Objects of the fuzz targets. A wrapper of clang prints the version that a file names.
cat >"$work/bin/other-clang" <<END
#!/bin/sh
[ "\$1" != --version ] || exec cat "$work/version"
exec clang "\$@"
END
chmod +x "$work/bin/other-clang"
echo 'clang version 1' >"$work/version"
fuzz_builds() { # WORDS...: Counts the compiled objects of fuzz targets.
    make BUILD="$tree" FUZZ_CC="$work/bin/other-clang" "$tree/fuzz/core/base/rng.o" "$core" "$@" >"$work/out" 2>&1 ||
        { cat "$work/out"; return 1; }
    cat "$work/out"
    compiled=$(grep -c '^  CC    .*(to be fuzzed)' "$work/out") || true
}
fuzz_is_still() { fuzz_builds && fuzz_builds && [ "$compiled" -eq 0 ]; }
clang_changes() { echo 'clang version 2' >"$work/version" && fuzz_builds && [ "$compiled" -eq 1 ] && [ "$(grep -c '^  CC ' "$work/out")" -eq 1 ]; }
fuzz_flags_change() { fuzz_builds FUZZ_CFLAGS="-O1 -I. -I$tree/generated" && [ "$compiled" -eq 1 ]; }

# The library of the kiosk faults is compiled without objects, in one command.
library_builds() { # WORDS...: Counts the commands that compile the library.
    make BUILD="$tree" CC="$work/bin/hidden-gcc" "$tree/tests/power/preload.so" "$@" >"$work/out" 2>&1 || { cat "$work/out"; return 1; }
    cat "$work/out"
    compiled=$(grep -c '^  LINK  .*preload' "$work/out") || true
}
library_follows_flags() {
    library_builds && [ "$compiled" -eq 1 ] && library_builds && [ "$compiled" -eq 0 ] &&
        library_builds OPT=-O1 && [ "$compiled" -eq 1 ]
}

echo 1..11
if [ -d /usr/include/assimp ]; then
    check 'a build without assimp compiles no object that reads its headers' starts_without
    check 'a second build compiles nothing' is_still
    check 'installing assimp recompiles its users and not the core' comes
    check 'the next build compiles nothing' is_still
    check 'removing assimp recompiles its users' goes
else
    for _ in 1 2 3 4 5; do skip 'assimp comes and goes' 'libassimp-dev is not installed'; done
    builds
fi
check 'other compiler flags recompile everything' flags_change
check 'another libgpiod recompiles the shell with its own sources' gpiod_changes
check 'other compiler flags recompile the library of the kiosk faults' library_follows_flags
if command -v clang >/dev/null; then
    check 'a second build compiles no fuzz target' fuzz_is_still
    check 'another clang recompiles the fuzz targets alone' clang_changes
    check 'other fuzz flags recompile the fuzz targets' fuzz_flags_change
else
    for _ in 1 2 3; do skip 'the fuzz targets follow clang' 'clang is not installed'; done
fi
