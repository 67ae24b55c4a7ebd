#!/bin/bash
# test_includes.sh -- each include rule of includes.sh refuses one made-up include, and allows its neighbour.
#
# The includes come from a made-up list, so that no compiler runs. Speaks TAP.
set -u
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=0
export CC=${CC:-gcc} BUILD=${BUILD:-build} PAIRS=$work/pairs EXCEPTIONS=$work/exceptions
freestanding=$($CC -print-file-name=include)
[ -d "$freestanding" ] || freestanding=$($CC -print-resource-dir)/include

ok() { # STATUS TEXT
    count=$((count + 1))
    [ "$1" -eq 0 ] && echo "ok $count - $2" || { echo "not ok $count - $2"; sed 's/^/# /' "$work/said"; }
}
check() { # FILE INCLUDED: the exit status of includes.sh for this one include.
    echo "$1 $2" >"$PAIRS"
    "$here/includes.sh" >"$work/said" 2>&1
}
refuses() { # RULE FILE INCLUDED TEXT
    ! check "$2" "$3" && grep -qF "$2: includes $3 -- $1: " "$work/said"
    ok $? "$4"
}
allows() { # FILE INCLUDED TEXT
    check "$1" "$2"
    ok $? "$3"
}
echo 'limit 0' >"$EXCEPTIONS"

refuses core core/view.c /usr/include/stdio.h 'the core may not include a hosted header'
refuses core core/view.c platform/hal.h 'nor the platform'
refuses core core/tank/tank.h drivers/null.h 'nor a driver'
allows core/view.c "$freestanding/stdint.h" 'but a freestanding one'
allows core/morph/growth.c "$BUILD/generated/species_table.h" 'and what was baked'

refuses base core/base/vec.h core/input.h 'core/base may not include a contract'
refuses base core/base/vec.h core/tank/fish.h 'nor the tank'
refuses contract core/output.h core/tank/tank.h 'a contract may not include the tank'
refuses contract core/scene.h core/core.h 'nor the whole state'
allows core/scene.h core/morph/species.h 'but the data of a species'
refuses layer core/morph/pose.c core/tank/fish.h 'the morph may not include the tank'
refuses layer core/sound/sound.c core/morph/morph.h 'the sound may not include the morph'
refuses layer core/tank/tank.c core/poi/poi.h 'the tank may not include the poi'
refuses layer core/tank/collision/box.c core/game/game.h 'nor may its folders include the game'
refuses layer core/tank/tank.c core/core.h 'nor the whole state'
allows core/tank/tank.c core/morph/morph.h 'but the morph'
refuses layer core/poi/paper/tear.c core/game/rules.h 'the poi may not include the game'
allows core/poi/catch/catch.c core/tank/tank.h 'but the tank'
refuses game core/game/round.c core/core.h 'the game may not include the whole state'
allows core/game/round.c core/poi/poi.h 'but the poi'

for folder in bot menu lab ranking accounting control; do
    refuses internal core/game/round.c core/game/$folder/any_internal.h "the game may not see what is internal to $folder"
    refuses internal core/game/other/any.c core/game/$folder/any_internal.h "nor may another folder of the game"
done
allows core/game/menu/menu_upkeep.c core/game/menu/any_internal.h 'the menu sees its own internal header'
refuses bot core/game/bot/targeting.c core/tank/tank.h 'a bot may not look into the tank'
refuses bot core/game/bot/bot.c core/game/game.h 'nor into the game'
allows core/game/bot/vision.c core/tank/tank.h 'but its vision, which reads for it, may'

refuses driver drivers/usb/usb_device.c core/core.h 'a driver may not see the whole state'
refuses driver drivers/usb/usb_device.c core/tank/tank.h 'nor the tank'
refuses driver drivers/usb/usb_device.c platform/board.h 'nor the board'
refuses driver drivers/usb/usb_device.c platform/store/storage.h 'nor the store'
allows drivers/usb/usb_device.c platform/hal.h 'but platform/hal.h'
allows drivers/usb/usb_device.c platform/os/log.h 'platform/os'
allows drivers/usb/usb_device.c core/input.h 'the contracts of the core'
allows drivers/usb/usb_device.c /usr/include/libusb-1.0/libusb.h 'and a library'

refuses os platform/os/log.c platform/board.h 'platform/os may not include the platform above it'
refuses os platform/os/log.c core/core.h 'nor the core'
allows platform/os/clock.c platform/hal.h 'but platform/hal.h'
refuses wiring platform/kiosk/kiosk.c drivers/null.h 'the frame loop may not name a driver'
refuses wiring platform/render/renderer.c drivers/hid/hid_descriptor.h 'nor may the renderer, not even a decoder'
refuses wiring platform/store/storage.c board/desktop/parts.h 'nor may the store name a board'
allows platform/kiosk/main.c board/desktop/parts.h 'main wires'
allows board/desktop/controllers.c drivers/usb/usb_transport.h 'and so does board/'
refuses ctl platform/ctl/devices/hid.c drivers/usb/usb_transport.h 'kingyoctl may not include a transport'
allows platform/ctl/devices/hid.c drivers/hid/hid_descriptor.h 'but a decoder'
allows platform/ctl/tank/tank.c core/tank/tank.h 'and what is public in the core'
refuses internal platform/ctl/tank/tank.c core/tank/collision/contact_solver_internal.h 'but nothing internal'
for file in platform/kiosk/kiosk.c drivers/null.c board/desktop/board.c platform/os/log.c; do
    refuses ctl $file platform/ctl/lib/ctl.h "$file may not include kingyoctl"
done
refuses kiosk platform/store/storage.c platform/kiosk/kiosk.h 'the store may not include the frame loop'
allows platform/ctl/play/replay.c platform/kiosk/recorder/replayer.h 'but kingyoctl may'

# ---- The list of exceptions ----
printf 'limit 1\nlayer core/tank/tank.c core/poi/poi.h # why\n' >"$EXCEPTIONS"
allows core/tank/tank.c core/poi/poi.h 'a named exception passes'
refuses layer core/tank/tank.h core/poi/poi.h 'but only for the file that it names'
printf 'limit 1\ncontract core/persistent_state.h core/poi/paper/sheet.h\n' >"$EXCEPTIONS"
allows drivers/sim/storage_sim.c core/poi/paper/sheet.h 'what a contract includes by exception, its users may include'
printf 'limit 1\ngame core/game/a.c core/core.h\ngame core/game/b.c core/core.h\n' >"$EXCEPTIONS"
! check core/game/a.c core/core.h && grep -q 'may only shrink' "$work/said"
ok $? 'more exceptions than the limit are refused'
printf 'limit 2\ngame core/game/a.c core/core.h\n' >"$EXCEPTIONS"
! check core/game/a.c core/core.h && grep -q 'lower the limit' "$work/said"
ok $? 'and so are fewer, until the limit is lowered'
echo "1..$count"
