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
    [ "$1" -eq 0 ] && echo "ok $count - $2" || { echo "not ok $count - $2"; sed 's/^/# /' "$work/log"; }
}
kind= # Kind of the made-up include: empty for what the compiler lists, otherwise `direct` or `state`.
check() { # FILE INCLUDED: Returns the exit status of includes.sh for this one include.
    echo "$1 $2 $kind" >"$PAIRS"
    "$here/includes.sh" >"$work/log" 2>&1
}
refuses() { # RULE FILE INCLUDED TEXT
    ! check "$2" "$3" && grep -qE "^$2: (includes|names) $3 -- $1: " "$work/log"
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
allows core/game/bot/snapshot.c core/scene.h 'a bot may include the scene'
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

# ---- Build tools ----
refuses assets assets/bake/text.c core/tank/tank.h 'a build tool may not include the tank'
refuses assets assets/bake/text.c platform/render/renderer.h 'a build tool may not include the renderer'
refuses assets assets/bake/species.c platform/store/storage.h 'a build tool may not include the store'
refuses assets assets/bake/species.c drivers/null.h 'a build tool may not include a driver'
allows assets/bake/species.c platform/species/pack.h 'a build tool may include the readers of species'
allows assets/bake/text.c /usr/include/stdio.h 'a build tool may include a library'
refuses assets platform/render/renderer.c assets/bake/bake.h 'the renderer may not include a build tool'
refuses assets core/view.c assets/font.h 'the core may not include the format of the fonts'
refuses assets platform/store/storage.c assets/font.h 'the store may not include the format of the fonts'
allows platform/render/text_draw.c assets/font.h 'the renderer may include the format of the fonts'

# ---- The table of the platform's folders: direct includes ----
kind=direct
refuses platform platform/os/log.c platform/watchdog.h 'platform/os may include only hal.h of the headers in platform/'
allows platform/os/clock.c platform/hal.h 'platform/os may include hal.h'
refuses platform platform/config/options.c platform/store/storage.h 'the options may not include the store'
refuses platform platform/config/options.c platform/hal.h 'the options may not include hal.h'
allows platform/config/options.c platform/board.h 'the options may include board.h'
refuses platform platform/species/text.c platform/render/paint.h 'the species may not include the renderer'
refuses platform platform/replay/replay.h platform/store/storage.h 'the format of recordings may not include the store'
refuses platform platform/store/storage.c platform/replay/replay.h 'the store may not include the format of recordings'
allows platform/store/sqlite/ledger_backup.h platform/panics.h 'the store may include panics.h'
refuses platform platform/render/renderer.c platform/config/options.h 'the renderer may not include the options'
allows platform/render/ui/lab/ui_lab.c platform/species/library.h 'the renderer may include the species'
refuses platform platform/kiosk/kiosk.c platform/render/renderer.h 'the frame loop may not include the renderer'
allows platform/kiosk/kiosk.c platform/watchdog.h 'the frame loop may include each header in platform/'
refuses platform platform/watchdog.c platform/kiosk/kiosk.h 'a file in platform/ may not include the frame loop'
refuses platform platform/audio.c platform/render/renderer.h 'a file in platform/ may not include the renderer'
allows platform/panics.c platform/replay/replay_format.h 'a file in platform/ may include the format of recordings'
allows platform/ctl/doctor/doctor.c platform/store/storage.h 'kingyoctl may include the store'
allows platform/render/pass/bloom.c platform/render/renderer.h 'a subfolder may include its folder'
TABLE=/dev/null check core/view.c core/view.h
grep -q 'no table of folders' "$work/log"
ok $? 'a page without the table is rejected'

# ---- Headers that the core offers: direct includes ----
refuses private core/poi/poi.c core/tank/collision/narrow_phase.h 'the poi may not include a private header of the tank'
refuses private core/game/menu/menu.c core/game/ranking/name_filter_any.h 'the menu may not include a private header of the ranking'
refuses private core/tank/tank.c core/tank/behavior/startle.h 'the tank may not include a private header of its subfolder'
allows core/tank/behavior/startle.c core/tank/shade.h 'a subfolder may include a private header of its folder'
allows core/game/bot/bot.c core/game/bot/vision.h 'a folder may include its private header'
allows core/game/round.c core/game/control/controller.h 'the game may include a header that the controllers offer to the core'
refuses private platform/kiosk/kiosk.c core/game/game.h 'the platform may not include the state of the game'
refuses private platform/kiosk/kiosk.c core/game/control/controller.h 'the platform may not include a header for the core'
refuses private platform/kiosk/kiosk.c core/tank/tank.h 'the platform may not include the tank'
refuses private drivers/null.c core/game/bot/bot.h 'a driver may not include the bots'
allows platform/ctl/tank/tank.c core/tank/tank.h 'kingyoctl may include the tank'
refuses private platform/ctl/tank/tank.c core/tank/collision/box.h 'kingyoctl may not include a private header of the tank'
allows platform/kiosk/kiosk.c core/core.h 'the platform may include core.h'
allows platform/render/renderer.c core/scene.h 'the platform may include a contract'

# ---- Reads of the core's state ----
kind=state
refuses state platform/kiosk/kiosk.c core.game 'the platform may not read the game'
refuses state platform/ctl/play/rounds.c core.world 'kingyoctl may not read the world of the kiosk'
refuses state board/desktop/board.c core.game 'a board may not read the game'
kind=

# ---- The list of exceptions ----
printf 'limit 1\nlayer core/tank/tank.c core/poi/poi.h # why\n' >"$EXCEPTIONS"
allows core/tank/tank.c core/poi/poi.h 'a listed exception is allowed'
refuses layer core/tank/tank.h core/poi/poi.h 'an exception holds only for its file'
printf 'limit 1\ncontract core/persistent_state.h core/poi/paper/sheet.h\n' >"$EXCEPTIONS"
allows drivers/sim/storage_sim.c core/poi/paper/sheet.h "a user of a contract may include the contract's exceptions"
refuses bot core/game/bot/snapshot.c core/poi/paper/sheet.h 'a bot may not include the sheet, which a contract includes'
printf 'limit 1\ngame core/game/a.c core/core.h\ngame core/game/b.c core/core.h\n' >"$EXCEPTIONS"
! check core/game/a.c core/core.h && grep -q 'may only shrink' "$work/log"
ok $? 'more exceptions than the limit are rejected'
printf 'limit 2\ngame core/game/a.c core/core.h\n' >"$EXCEPTIONS"
! check core/game/a.c core/core.h && grep -q 'lower the limit' "$work/log"
ok $? 'fewer exceptions than the limit are rejected'
echo "1..$count"
