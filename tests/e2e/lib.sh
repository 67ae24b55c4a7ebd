# lib.sh -- a virtual screen, the real kiosk and a hand on a real pointer, for the tests beside it.
#
# Source it; it leaves nothing behind: screens, kiosks and files go when the script ends.
# shellcheck shell=bash disable=SC2034  # what it sets is used by those who source it
set -u
BUILD=${BUILD:-build}
work=$(mktemp -d)
screen_pid='' kiosk_pid='' count=0
export SDL_AUDIODRIVER=dummy LC_ALL=C.UTF-8
unset WAYLAND_DISPLAY DISPLAY

leave() {
    [ -n "$kiosk_pid" ] && kill -9 "$kiosk_pid" 2>/dev/null
    [ -n "$screen_pid" ] && kill "$screen_pid" 2>/dev/null
    wait 2>/dev/null
    rm -rf "$work"
}
trap leave EXIT

ok() { # STATUS TEXT [FILE that explains a failure]
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $count - $2"
    else
        echo "not ok $count - $2"
        [ $# -gt 2 ] && [ -f "$3" ] && sed 's/^/# /' "$3" | head -20
    fi
    return "$1"
}

done_testing() {
    echo "1..$count"
}

open_screen() { # Sets DISPLAY to a fresh screen of 1280x720.
    : >"$work/display"
    # Without -noreset a server that its last client has left also throws out the next one.
    Xvfb -displayfd 1 -screen 0 1280x720x24 -nolisten tcp -noreset >"$work/display" 2>"$work/xvfb.log" &
    screen_pid=$!
    disown "$screen_pid"
    for _ in $(seq 100); do
        [ -s "$work/display" ] && break
        sleep 0.1
    done
    DISPLAY=:$(cat "$work/display")
    export DISPLAY
}

close_screen() {
    kill -9 "$screen_pid" 2>/dev/null
    screen_pid=''
}

# Starts the kiosk in a window and waits until it shows something: up to 30 s on a busy machine.
start_kiosk() { # OPTIONS...
    "$BUILD/kingyo" --window 1280x720 --lang en --data "$work/data" "$@" >"$work/out" 2>"$work/err" &
    kiosk_pid=$!
    for _ in $(seq 150); do
        kill -0 "$kiosk_pid" 2>/dev/null || return 1
        window=$(xdotool search --onlyvisible --name Kingyo 2>/dev/null | head -1)
        if [ -n "$window" ] && [ "$(shown colours)" -gt 200 ]; then
            return 0
        fi
        sleep 0.2
    done
    return 1
}

# Presses Esc until the kiosk ends: the first press asks, and the second press within 5 s ends the kiosk. On a busy
# machine both presses may fall into one frame, or 5 s may pass between the frames of two presses.
# tests/unit/platform/kiosk/test_kiosk.c proves the exact numbers without a clock of the machine: the second press ends the kiosk
# (test_a_second_press_of_quit_ends_the_loop_after_its_frame), and one press alone never does
# (test_one_press_of_quit_never_ends_the_loop).
quit_by_key() {
    for _ in 1 2 3 4 5 6; do
        xdotool key Escape
        sleep 1
        kill -0 "$kiosk_pid" 2>/dev/null || return 0
    done
}

# Waits for the kiosk's end, up to SECONDS; sets `code` to its exit status, or to 124.
end_of_kiosk() { # SECONDS
    for _ in $(seq $(($1 * 10))); do
        if ! kill -0 "$kiosk_pid" 2>/dev/null; then
            wait "$kiosk_pid" 2>/dev/null
            code=$?
            kiosk_pid=''
            return
        fi
        sleep 0.1
    done
    kill -9 "$kiosk_pid"
    kiosk_pid=''
    code=124
}

# What the screen shows now: its number of colours, or the share of pixels in thousandths that are
# the tank's blue or a goldfish's red. Looked at in a quarter of the size: fish are larger than that.
shown() { # colours|blue|red
    import -silent -window root miff:- 2>/dev/null | convert miff:- -sample '320x180!' -depth 8 rgb:- | od -An -v -tu1 -w3 |
        awk -v what="$1" '
            { seen[$1 "," $2 "," $3] = 1 }
            $3 > 110 && $3 > $1 + 40 { blue++ }
            $1 > 140 && $2 < 120 && $3 < 100 && $1 > $2 + 50 { red++ }
            END {
                for (colour in seen) colours++
                print what == "colours" ? colours + 0 : int(1000 * (what == "blue" ? blue : red) / (NR ? NR : 1))
            }'
}

caught() { # FILE: how many fish the recording says were landed so far.
    "$BUILD/kingyoctl" replay info --json "$1" 2>/dev/null | sed -n 's/.*"caught": *\([0-9]*\).*/\1/p'
}

# One line on standard error, nothing that looks like a crash.
one_line() { # FILE
    [ "$(wc -l <"$1")" -eq 1 ] && ! grep -qiE 'sanitizer|segmentation|assert|panic|core dumped' "$1"
}
