#!/bin/bash
# test_includes.sh -- each include rule of includes.sh rejects one forbidden include and allows a
# similar valid one.
# The includes come from a generated list, so that no compiler runs. Speaks TAP.
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
check() { # FILE INCLUDED: Returns the exit status of includes.sh for this one include.
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
refuses core core/view.c platform/hal.h 'the core may not include the platform'
refuses core core/tank/tank.h drivers/null.h 'the core may not include a driver'
allows core/view.c "$freestanding/stdint.h" 'the core may include a freestanding header'
allows core/morph/growth.c "$BUILD/generated/species_table.h" 'the core may include a baked header'

refuses base core/base/vec.h core/input.h 'core/base may not include a contract'
refuses base core/base/vec.h core/tank/fish.h 'core/base may not include the tank'
refuses contract core/output.h core/tank/tank.h 'a contract may not include the tank'
refuses contract core/scene.h core/core.h 'a contract may not include the whole state'
allows core/scene.h core/morph/species.h 'a contract may include the data of a species'
refuses layer core/morph/pose.c core/tank/fish.h 'the morph may not include the tank'
refuses layer core/sound/sound.c core/morph/morph.h 'the sound may not include the morph'
refuses layer core/tank/tank.c core/poi/poi.h 'the tank may not include the poi'
refuses layer core/tank/collision/box.c core/game/game.h 'a folder of the tank may not include the game'
refuses layer core/tank/tank.c core/core.h 'the tank may not include the whole state'
allows core/tank/tank.c core/morph/morph.h 'the tank may include the morph'
refuses layer core/poi/paper/tear.c core/game/rules.h 'the poi may not include the game'
allows core/poi/catch/catch.c core/tank/tank.h 'the poi may include the tank'
refuses game core/game/round.c core/core.h 'the game may not include the whole state'
allows core/game/round.c core/poi/poi.h 'the game may include the poi'

for folder in bot menu lab ranking accounting control; do
    refuses internal core/game/round.c core/game/$folder/any_internal.h "the game may not include an internal header of $folder"
    refuses internal core/game/other/any.c core/game/$folder/any_internal.h "another folder of the game may not include an internal header of $folder"
done
allows core/game/menu/menu_upkeep.c core/game/menu/any_internal.h 'the menu may include its own internal header'
refuses bot core/game/bot/targeting.c core/tank/tank.h 'a bot may not include the tank'
refuses bot core/game/bot/bot.c core/game/game.h 'a bot may not include the game'
allows core/game/bot/vision.c core/tank/tank.h 'the vision of the bots may include the tank'

refuses driver drivers/usb/usb_device.c core/core.h 'a driver may not include the whole state'
refuses driver drivers/usb/usb_device.c core/tank/tank.h 'a driver may not include the tank'
refuses driver drivers/usb/usb_device.c platform/board.h 'a driver may not include the board'
refuses driver drivers/usb/usb_device.c platform/store/storage.h 'a driver may not include the store'
allows drivers/usb/usb_device.c platform/hal.h 'a driver may include platform/hal.h'
allows drivers/usb/usb_device.c platform/os/log.h 'a driver may include platform/os'
allows drivers/usb/usb_device.c core/input.h 'a driver may include the contracts of the core'
allows drivers/usb/usb_device.c /usr/include/libusb-1.0/libusb.h 'a driver may include a library'

refuses os platform/os/log.c platform/board.h 'platform/os may not include the platform above it'
refuses os platform/os/log.c core/core.h 'platform/os may not include the core'
allows platform/os/clock.c platform/hal.h 'platform/os may include platform/hal.h'
refuses wiring platform/kiosk/kiosk.c drivers/null.h 'the frame loop may not name a driver'
refuses wiring platform/render/renderer.c drivers/hid/hid_descriptor.h 'the renderer may not include a decoder'
refuses wiring platform/store/storage.c board/desktop/parts.h 'the store may not include a board'
allows platform/kiosk/main.c board/desktop/parts.h 'main may include a board'
allows board/desktop/controllers.c drivers/usb/usb_transport.h 'board/ may include a driver'
refuses ctl platform/ctl/devices/hid.c drivers/usb/usb_transport.h 'kingyoctl may not include a transport'
allows platform/ctl/devices/hid.c drivers/hid/hid_descriptor.h 'kingyoctl may include a decoder'
allows platform/ctl/tank/tank.c core/tank/tank.h 'kingyoctl may include a public header of the core'
refuses internal platform/ctl/tank/tank.c core/tank/collision/contact_solver_internal.h 'kingyoctl may not include an internal header of the core'
for file in platform/kiosk/kiosk.c drivers/null.c board/desktop/board.c platform/os/log.c; do
    refuses ctl $file platform/ctl/lib/ctl.h "$file may not include kingyoctl"
done
refuses kiosk platform/store/storage.c platform/kiosk/kiosk.h 'the store may not include the frame loop'
allows platform/ctl/play/replay.c platform/kiosk/recorder/replayer.h 'kingyoctl may include the replayer of the kiosk'

# ---- The list of exceptions ----
printf 'limit 1\nlayer core/tank/tank.c core/poi/poi.h # why\n' >"$EXCEPTIONS"
allows core/tank/tank.c core/poi/poi.h 'a listed exception is allowed'
refuses layer core/tank/tank.h core/poi/poi.h 'an exception holds only for its file'
printf 'limit 1\ncontract core/persistent_state.h core/poi/paper/sheet.h\n' >"$EXCEPTIONS"
allows drivers/sim/storage_sim.c core/poi/paper/sheet.h "a user of a contract may include the contract's exceptions"
printf 'limit 1\ngame core/game/a.c core/core.h\ngame core/game/b.c core/core.h\n' >"$EXCEPTIONS"
! check core/game/a.c core/core.h && grep -q 'may only shrink' "$work/said"
ok $? 'more exceptions than the limit are rejected'
printf 'limit 2\ngame core/game/a.c core/core.h\n' >"$EXCEPTIONS"
! check core/game/a.c core/core.h && grep -q 'lower the limit' "$work/said"
ok $? 'fewer exceptions than the limit are rejected'
echo "1..$count"
