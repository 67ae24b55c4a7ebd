#!/bin/bash
# sanitizers.sh -- controller input, mappings, learning, the mapping store, the controller manager,
# their menu pages and a paid round with a cable that is unplugged, all under the sanitizers. All
# code of drivers/ and of the game that they call is compiled for address and undefined behaviour,
# and again for threads. Run by `make test-hid-sanitizers`.
set -eu
build=${BUILD:-build}
read -ra cflags <<<"${CFLAGS:--std=c17 -O1 -g -I.}"
cflags+=(-Wno-conversion) # The instrumentation of shifts and sums widens narrow integers.
cc=${CC:-gcc}
tests=(drivers/hid/test_{hid_mapping,hid_pose_decoder,hid_pose_pointing,hid_pose_own,hid_learn}
    drivers/hid/test_{hid_mapping_store,controller_manager,poi_hid} drivers/gamepad/test_stick_motion
    core/game/menu/test_{menu,menu_controllers,menu_poi} core/game/accounting/test_credit
    platform/kiosk/test_{menu_devices,unplug_paid})
mapfile -t sources < <(find core/game drivers/hid -name '*.c')
sources+=(drivers/pointer/pointer_poi.c drivers/gamepad/stick_motion.c drivers/null.c
    drivers/sim/{hid_sim,hal_sim}.c
    platform/kiosk/{kiosk,sampler,operator_view}.c tests/unit/support/panic.c)

for sanitizers in address,undefined thread; do
    home=$build/hid-sanitizers/${sanitizers%%,*}
    mkdir -p "$home"
    objects=()
    for source in "${sources[@]}"; do
        object=$home/${source//\//,}.o
        $cc "${cflags[@]}" -fsanitize="$sanitizers" -fno-sanitize-recover=all -c -o "$object" "$source"
        objects+=("$object")
    done
    for name in "${tests[@]}"; do
        program=$home/${name##*/}
        $cc "${cflags[@]}" -fsanitize="$sanitizers" -fno-sanitize-recover=all -o "$program" "tests/unit/$name.c" \
            "${objects[@]}" "$build"/{core,shell,core}.a -lcmocka -lm -lpthread
        CMOCKA_MESSAGE_OUTPUT=TAP "$program" >"$program.log" 2>&1 || { cat "$program.log" >&2; exit 1; }
        echo "  ok    ${name##*/} under $sanitizers: $(grep -c '^ok' "$program.log") tests"
    done
done
