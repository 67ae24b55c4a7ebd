#!/bin/bash
# sanitizers.sh -- hands, maps, learning, the book, the desk, the menu that leads to it, and a paid round over a cable
# that comes out, under the sanitizers: everything of drivers/ and of the game that they call is compiled for address +
# undefined behaviour, and again for threads. Run by `make test-hand-sanitizers`.
set -eu
build=${BUILD:-build}
read -ra cflags <<<"${CFLAGS:--std=c17 -O1 -g -I.}"
cflags+=(-Wno-conversion) # What checks shifts and sums makes wider numbers of small ones.
cc=${CC:-gcc}
tests=(hid_map hid_hand hid_learn hid_book hid_desk poi_hid fly_poi menu menu_desk credit unplug_paid)
sources=(drivers/{hid_*,poi_hid,poi_report,poi_descriptor,fly_poi,dip,pose_fan,pointer_*,clock_sim,display_sim,null}.c
    core/game/*.c platform/kiosk/{kiosk,hands,resample,dressing,file_notes}.c tests/unit/panic.c)

for sanitizers in address,undefined thread; do
    home=$build/hand-sanitizers/${sanitizers%%,*}
    mkdir -p "$home"
    objects=()
    for source in "${sources[@]}"; do
        object=$home/$(basename "$source" .c).o
        $cc "${cflags[@]}" -fsanitize="$sanitizers" -fno-sanitize-recover=all -c -o "$object" "$source"
        objects+=("$object")
    done
    for name in "${tests[@]}"; do
        program=$home/test_$name
        $cc "${cflags[@]}" -fsanitize="$sanitizers" -fno-sanitize-recover=all -o "$program" "tests/unit/test_$name.c" \
            "${objects[@]}" "$build"/{core,shell,core}.a -lcmocka -lm -lpthread
        CMOCKA_MESSAGE_OUTPUT=TAP "$program" >"$program.log" 2>&1 || { cat "$program.log" >&2; exit 1; }
        echo "  ok    test_$name under $sanitizers: $(grep -c '^ok' "$program.log") tests"
    done
done
