#!/bin/bash
# test_slots.sh -- the state of the two root slots on a file: each start of a trial is counted, a write that is cut at any
# byte leaves the state before or after it, and damaged states are detected. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh and slots.sh set these variables
. "$(dirname "$0")/../lib.sh"
cd "$(dirname "$0")/../.." || exit 1
. board/image/slots/slots.sh
file=$work/slots

fresh() { rm -f "$file" && truncate -s 1M "$file"; }
holds() { # "NUMBER GOOD TRIAL STARTS"
    slots_read "$file" || return 1
    echo "has $number $good $trial $starts"
    [ "$number $good $trial $starts" = "$1" ]
}
begins() { # GOOD TRIAL STARTS: a new file with this state
    fresh && slots_write "$file" "$@"
}

empty_is_slot_a() { fresh && ! slots_read "$file" && [ "$good$trial$starts" = a-0 ] && [ "$(slots_order "$file")" = 'a b' ]; }
check 'an empty partition starts slot a, then slot b' empty_is_slot_a
no_file() { ! slots_read "$work/none" && [ "$(slots_order "$work/none")" = 'a b' ] && [ ! -e "$work/none" ]; }
check 'a missing partition starts slot a, then slot b' no_file
check 'a written state is read back' begins b - 0
check 'the state has the number 1' holds '1 b - 0'
good_first() { begins b - 0 && [ "$(slots_order "$file")" = 'b a' ] && holds '1 b - 0'; }
check 'without a trial the good slot starts, and nothing is written' good_first

trial_ends() {
    begins a b 2 && [ "$(slots_order "$file")" = 'b a' ] && holds '2 a b 1' &&
        [ "$(slots_order "$file")" = 'b a' ] && holds '3 a b 0' &&
        [ "$(slots_order "$file")" = 'a b' ] && holds '3 a b 0'
}
check 'a trial has two starts, and then the good slot starts again' trial_ends
unwritable() { # Root can write any file, so a device without space stands for a disk that cannot be written.
    begins a b 2 && [ "$( dd() { case $* in *of=*) cat >/dev/null; return 1 ;; *) command dd "$@" ;; esac; }; slots_order "$file")" = 'a b' ]
}
check 'a trial that cannot be counted does not start' unwritable
lost_write() { # The disk confirms the write but does not keep it.
    begins a b 2 && [ "$( dd() { case $* in *of=*) cat >/dev/null ;; *) command dd "$@" ;; esac; }; slots_order "$file")" = 'a b' ]
}
check 'a trial whose count is not kept does not start' lost_write

copies_differ() { # The two copies of the state lie 512 KiB apart.
    begins a - 0 && slots_write "$file" b - 0 && cp "$file" "$work/one" &&
        [ "$(dd if="$file" bs=512 count=1 status=none | cut -d' ' -f3)" = 1 ] &&
        [ "$(dd if="$file" bs=512 skip=1024 count=1 status=none | cut -d' ' -f3)" = 2 ]
}
check 'two writes go to two copies' copies_differ

# The first BYTES of the new sector reach the disk, and then the power is cut.
cut_write() { # BYTES
    cp "$work/before" "$file"
    dd if="$work/after" of="$file" bs=1 skip="$place" seek="$place" count="$1" conv=notrunc status=none
}
each_cut() { # TRIAL STARTS: cuts the write after a state with this trial.
    local at
    begins a "$1" "$2" && slots_write "$file" a - 0 && slots_write "$file" a b 2 && cp "$file" "$work/before" || return 1
    slots_write "$file" a b 1 && cp "$file" "$work/after" || return 1
    place=$((512 * slots_next == 0 ? 524288 : 0))
    cmp -s -n 512 -i "$place" "$work/before" "$work/after" && return 1 # The write changed the other copy.
    for ((at = 0; at <= 512; at += 19)); do
        cut_write "$at"
        holds '3 a b 2' || holds '4 a b 1' || { echo "cut after $at bytes"; return 1; }
    done
    cut_write 512 && holds '4 a b 1'
}
check 'a write that is cut after a number of bytes leaves the state before or after it' each_cut - 0

damage_each_byte() { # The valid line, each of its bytes changed in turn: the older copy counts.
    local at length
    begins a - 0 && slots_write "$file" b - 0 && cp "$file" "$work/before" || return 1
    length=$(dd if="$file" bs=512 skip=1024 count=1 status=none | head -1 | wc -c)
    for ((at = 0; at < length - 1; at += 5)); do
        cp "$work/before" "$file"
        printf '%s' 7 | dd of="$file" bs=1 seek=$((524288 + at)) conv=notrunc status=none
        cmp -s "$file" "$work/before" || holds '1 a - 0' || { echo "byte $at"; return 1; }
    done
}
check 'a changed byte makes a copy invalid' damage_each_byte

forge() { # WORDS: a copy with these words and their correct checksum
    fresh && printf '%-511s\n' "$1 $(slots_sum "$1")" | dd of="$file" conv=notrunc status=none
}
refused() { forge "$1" && ! slots_read "$file"; }
for words in 'kingyo-slots 2 1 a - 0' 'kingyo-slots 1 1 c - 0' 'kingyo-slots 1 1 a a 2' 'kingyo-slots 1 01 a - 0' \
    'kingyo-slots 1 -1 a - 0' 'kingyo-slots 1 1234567890 a - 0' 'kingyo-slots 1 1 a b -1' 'kingyo-slots 1 1 a b' \
    'kingyo-slots 1 1 a b 2 x' 'kingyo-slots 1 1 - b 2' 'other 1 1 a - 0'; do
    check "a copy with '$words' is invalid" refused "$words"
done
noise() { head -c 1048576 /dev/urandom >"$file" && ! slots_read "$file" && [ "$(slots_order "$file")" = 'a b' ]; }
check 'random bytes are no state' noise
over_noise() { slots_write "$file" b a 2 && holds '1 b a 2'; }
check 'a state is written over random bytes' over_noise

# ---- mark-good
tool() { SCREENS=$work/drm SLOTS=$file SLOT_FILE=$work/slot STATUS=$work/status.json timeout 10 sh "$work/mark-good" "$@"; }
cp board/image/slots/mark-good board/image/slots/slots.sh "$work/"
echo b >"$work/slot"
trial_is_detected() { begins a b 1 && tool is-trial; }
check 'a start of the slot on trial is a trial' trial_is_detected
not_the_old() { begins b a 0 && ! tool is-trial; }
check 'a start of the good slot is no trial' not_the_old
marks() { begins a b 1 && tool mark && holds '2 b - 0'; }
check 'a marked slot is the good one' marks
status() { # UP_S SHOWN
    printf '{\n  "version": "0.1.0",\n  "up_s": %s,\n  "phase": "attract",\n  "frames": {"count": 9, "shown": %s},\n' "$@" >"$work/status.json"
}
screen() { # STATUS: the state of the second of two connectors
    mkdir -p "$work/drm/card0-HDMI-A-1" "$work/drm/card0-HDMI-A-2"
    echo disconnected >"$work/drm/card0-HDMI-A-1/status"
    echo "$1" >"$work/drm/card0-HDMI-A-2/status"
}
awaits() { status 10 true && screen connected && tool await; }
check 'a kiosk that runs for 10 s ends the trial' awaits
waits_on() { # UP_S SHOWN
    status "$@"
    SCREENS=$work/drm SLOTS=$file SLOT_FILE=$work/slot STATUS=$work/status.json timeout 2 sh "$work/mark-good" await
    [ $? -eq 124 ]
}
check 'a kiosk that runs for 9 s does not' waits_on 9 true
check 'a status that is no number does not' waits_on '"99"' true
check 'a kiosk without a picture on a connected screen does not' waits_on 99 false
unplugged() { status 10 false && screen disconnected && tool await; }
check 'without a connected screen, no picture is needed' unplugged
no_graphics() { rm -r "$work/drm" && status 10 false && tool await; }
check 'without graphics, no picture is needed' no_graphics
unit=board/image/root/etc/systemd/system/kingyo-slot-good.service
# The devices of a unit are denied by its control group, which "+" does not change.
allows() { ! grep -q '^PrivateDevices=yes' $unit && grep -qx 'DeviceAllow=/dev/kingyo/slots rw' $unit; }
check 'the step of root may write the state' allows
restarts() { grep -qx 'FailureAction=reboot' $unit && grep -qx 'ExecCondition=+/usr/lib/kingyo/mark-good is-trial' $unit; }
check 'a system that does not open restarts the machine, but only on trial' restarts
echo "1..$count"
