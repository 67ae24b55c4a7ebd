# lib.sh -- shared functions of the end-to-end tests: a virtual screen, the kiosk on that screen
# and TAP lines. Source this file. When the script ends, the screen, the kiosk and the temporary
# files are removed.
# shellcheck shell=bash disable=SC2034  # the sourcing scripts use these variables
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

# Ends the test if the virtual screen or the kiosk has ended without the test's order. The last lines
# then give the reason, because every later check would only wait in vain. Exit status 75 means that
# the screen ended, which the kiosk rarely causes: tests/run.sh repeats the test once and says so.
check_processes() {
    local status
    if [ -n "$screen_pid" ] && ! kill -0 "$screen_pid" 2>/dev/null; then
        tail -n 10 "$work/xvfb.log" "$work/err" 2>/dev/null | sed 's/^/# /'
        echo 'Bail out! The virtual screen has ended.'
        exit 75
    fi
    if [ -n "$kiosk_pid" ] && ! kill -0 "$kiosk_pid" 2>/dev/null; then
        wait "$kiosk_pid" 2>/dev/null
        status=$?
        tail -n 40 "$work/out" "$work/err" | sed 's/^/# /'
        echo "Bail out! The kiosk has ended with status $status."
        exit 1
    fi
}

ok() { # STATUS TEXT [FILE that explains a failure]
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $count - $2"
    else
        echo "not ok $count - $2"
        [ $# -gt 2 ] && [ -f "$3" ] && sed 's/^/# /' "$3" | head -20
        check_processes
    fi
    return "$1"
}

done_testing() {
    echo "1..$count"
}

open_screen() { # Sets DISPLAY to a new virtual screen of 1280x720.
    : >"$work/display"
    # Without -noreset the X server resets when its last client leaves, and then rejects the next
    # client.
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

# Starts the kiosk in a window and waits until its picture appears. On a busy machine this takes up
# to 30 s.
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

# Presses Esc until the kiosk ends. The first press asks, and a second press within 5 s ends the
# kiosk. On a busy machine both presses may fall into one frame, or 5 s may pass between the frames
# of two presses. tests/unit/platform/kiosk/test_kiosk.c proves the exact numbers with a simulated
# clock: the second press ends the kiosk, and one press never does.
quit_by_key() {
    for _ in 1 2 3 4 5 6; do
        xdotool key Escape
        sleep 1
        kill -0 "$kiosk_pid" 2>/dev/null || return 0
    done
}

# Waits up to SECONDS until the kiosk ends. Sets `code` to its exit status, or to 124 after a
# timeout.
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

# Prints the number of colours of the screen, or the share of pixels in thousandths that have the
# blue-green of the tank or the red of a goldfish. The picture is sampled at a quarter of its size,
# because a fish is larger than four pixels.
shown() { # colours|blue|red
    import -silent -window root miff:- 2>/dev/null | convert miff:- -sample '320x180!' -depth 8 rgb:- | od -An -v -tu1 -w3 |
        awk -v what="$1" '
            { seen[$1 "," $2 "," $3] = 1 }
            $3 > 70 && $3 > $1 + 25 && $2 > $1 + 20 { blue++ }
            $1 > 140 && $2 < 120 && $3 < 100 && $1 > $2 + 50 { red++ }
            END {
                for (colour in seen) colours++
                print what == "colours" ? colours + 0 : int(1000 * (what == "blue" ? blue : red) / (NR ? NR : 1))
            }'
}

caught() { # FILE: Prints the number of fish that were caught so far according to the recording.
    "$BUILD/kingyoctl" replay info --json "$1" 2>/dev/null | sed -n 's/.*"caught": *\([0-9]*\).*/\1/p'
}

# Standard error has one line, and no sign of a crash.
one_line() { # FILE
    [ "$(wc -l <"$1")" -eq 1 ] && ! grep -qiE 'sanitizer|segmentation|assert|panic|core dumped' "$1"
}
