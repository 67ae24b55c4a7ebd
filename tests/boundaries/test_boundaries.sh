#!/bin/bash
# test_boundaries.sh -- `make boundaries` fails when one bad line is added to a source or a header.
# test_includes.sh tests each rule between two folders without a compiler. This test works in a
# copy of the tree and of the build folder BUILD, so that only the file with the bad line is
# compiled again. Speaks TAP.
set -u
BUILD=${BUILD:-build}
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
tar cf - --exclude="$BUILD/tests" --exclude="$BUILD/results" --exclude='*.a' Makefile core platform drivers \
    board assets tests "$BUILD" | tar xf - -C "$copy"
count=0

ok() { # STATUS TEXT
    count=$((count + 1))
    [ "$1" -eq 0 ] && echo "ok $count - $2" || echo "not ok $count - $2"
}

boundaries() { # Checks the includes of FILE only.
    make -C "$copy" --no-print-directory BUILD="$BUILD" ONLY="${1:-}" boundaries 2>&1
}

# Adds LINE to the end of FILE. `make boundaries` must then fail with a message that names FILE (or
# its object) and RULE.
refuses() { # FILE LINE RULE TEXT
    local file=$copy/$1 output status
    mkdir -p "$(dirname "$file")"
    local had=0
    [ -f "$file" ] && had=1 && cp -p "$file" "$copy/kept"
    printf '%s\n' "$2" >>"$file"
    output=$(boundaries "$1")
    status=$?
    [ $status -ne 0 ] && grep -q "${1%.*}" <<<"$output" && grep -q -- "$3" <<<"$output"
    status=$?
    ok $status "$4"
    [ $status -eq 0 ] || sed 's/^/# /' <<<"$output" | tail -15
    if [ $had -eq 1 ]; then mv "$copy/kept" "$file"; else rm "$file"; fi
}

output=$(boundaries)
status=$?
ok $status 'the unchanged tree keeps every rule'
[ $status -eq 0 ] || sed 's/^/# /' <<<"$output"

any_of() { find "$1" -name "$2" ! -name main.c | sort | head -1; }
driver=$(any_of drivers '*.c')
render=$(any_of platform/render '*.c')

core='includes only core'
refuses core/view.c '#include <stdio.h>' "$core" 'the core may not include a hosted header'
refuses core/view.c '#include <math.h>' "$core" 'the core may not include the mathematics library'
refuses core/view.c '#include "platform/hal.h"' "$core" 'the core may not include the platform'
refuses core/unused.h '#include <stdlib.h>' "$core" 'an unused header of the core may not include a hosted header'
refuses core/view.c 'float kept_busy(float x); float sinf(float); float kept_busy(float x) { return sinf(x); }' \
    'sinf: needed by' 'the core may not call libm, declared by hand or not'
refuses core/view.c 'void *hoard(void); void *malloc(unsigned long); void *hoard(void) { return malloc(1); }' \
    'malloc: needed by' 'the core may not allocate memory'
refuses core/game/bot/targeting.c '#include "core/tank/tank.h"' 'a bot knows the game' 'a bot may not include the tank'
refuses core/game/bot/bot.c '#include "core/core.h"' 'a bot knows the game' 'a bot may not include the whole state'
refuses "${driver:-drivers/a.c}" '#include "core/core.h"' 'a driver includes only' \
    "a driver may not include the core's state"
refuses "${driver:-drivers/a.c}" '#include "platform/board.h"' 'a driver includes only' 'a driver may not include the board'
refuses drivers/unused.h '#include "platform/render/renderer.h"' 'a driver includes only' 'an unused header of a driver may not include the renderer'
refuses "$render" "#include \"$(any_of drivers '*.h')\"" 'only board/ and main' \
    'the platform may not include a driver'
refuses "$render" '#include "platform/config/options.h"' 'does not let render' \
    'the renderer may not include a folder that its row of the table does not name'
refuses "$render" '#include "core/game/phases.h"' 'public_headers.txt does not offer' \
    'the platform may not include a private header of the core'
refuses assets/bake/wood.c '#include "core/tank/tank.h"' 'a build tool includes only' 'a build tool may not include the tank'
reads='uint32_t now(const struct core *core); uint32_t now(const struct core *core) { return core->game.tick; }'
refuses platform/kiosk/run_common.c "$reads" 'does not read the game' "the platform may not read the core's state"
refuses platform/kiosk/run_common.c 'struct world; /* of a tank */' 'names core.world' "the platform may not name the core's state"
printf '%s\n' '/* core->game.tick in a comment' ' * core->world. */ const char *in_a_text = "a.game";' >>"$copy/platform/kiosk/run_common.c"
make -C "$copy" --no-print-directory BUILD="$BUILD" ONLY=platform/kiosk/run_common.c includes >/dev/null 2>&1
ok $? 'comments and strings may name the state'
echo "1..$count"
