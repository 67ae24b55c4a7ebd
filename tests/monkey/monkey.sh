#!/bin/bash
# monkey.sh SECONDS [SEED] -- random input for the kiosk that was built with the sanitizers.
# In the first half of the time the frame loop runs off screen under tests/monkey/monkey.c. In the
# second half the real kiosk runs on a virtual screen under tests/monkey/fingers.c. It must
# continue to draw frames. Two presses of Esc must end it with code 0 (this script starts it
# again), and so must SIGTERM at the end. Exits with 1 on any failure. SEED repeats a random
# sequence.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
build=${BUILD:-build}
BUILD=$build/monkey
. "$(dirname "$0")/../e2e/lib.sh"
seconds=$1 seed=${2:-$(date +%s)}
half=$(((seconds + 1) / 2))
status=$work/run/status.json
# Limit in seconds. A frame under the sanitizers on a busy machine takes 0.3 s, and the first
# picture takes 5 s.
stuck_s=20
export ASAN_OPTIONS=detect_leaks=0:handle_segv=2:handle_sigfpe=2:handle_sigbus=2:handle_sigill=2
export UBSAN_OPTIONS=print_stacktrace=1
echo "  monkey: seed $seed, $half s of frames off screen, then $((seconds - half)) s on a virtual screen"

fail() { # TEXT [FILE]: Prints TEXT, the seed and the head of FILE, and ends with 1.
    echo "  FAIL  monkey, SEED=$seed: $1"
    [ $# -gt 1 ] && head -60 "$2" | sed 's/^/        /'
    exit 1
}

"$BUILD/monkey" "$seed" "$half" >"$work/output" 2>&1 || fail "the frame loop: exit code $?" "$work/output"
sed 's/^/  ok    off screen: /' "$work/output"

open_kiosk() {
    rm -f "$status"
    "$BUILD/kingyo" --window 320x240 --lang en --keyboard on --mode festival --coins 1 --fish 40 --seed "$seed" \
        --data "$work/data" >"$work/out" 2>"$work/err" &
    kiosk_pid=$!
    moved_s=$SECONDS
    seen=none
}
frames() { sed -n 's/.*"frames": {"count": \([0-9]*\).*/\1/p' "$status" 2>/dev/null; }
check_end() { # TEXT: The kiosk must have ended with code 0 and without a fault.
    grep -qiE 'sanitizer|runtime error|panic' "$work/err" && fail "$1: a fault" "$work/err"
    [ "$code" -eq 0 ] || fail "$1: exit code $code" "$work/err"
}

mkdir -p "$work/data" "$work/run"
export RUNTIME_DIRECTORY=$work/run
open_screen
open_kiosk
quits=0 total=0
"$build/tests/monkey/fingers" "$seed" $((seconds - half)) >"$work/output" 2>&1 &
fingers_pid=$!
trap 'kill "$fingers_pid" 2>/dev/null; leave' EXIT
watch() { # Checks the kiosk once, and starts it again after a normal end.
    sleep 0.5
    now=$(frames)
    if ! kill -0 "$kiosk_pid" 2>/dev/null; then
        end_of_kiosk 1
        check_end 'the kiosk ended'
        quits=$((quits + 1))
        open_kiosk
    elif [ -n "$now" ] && [ "$now" != "$seen" ]; then
        [ "$seen" != none ] && [ "$now" -gt "$seen" ] && total=$((total + now - seen))
        seen=$now
        moved_s=$SECONDS
    elif [ $((SECONDS - moved_s)) -gt $stuck_s ]; then
        fail "no frame for $stuck_s s" "$work/err"
    fi
}
while kill -0 "$fingers_pid" 2>/dev/null; do
    watch
done
wait "$fingers_pid" || fail 'the virtual fingers failed' "$work/output"
watch # The last Esc may end the kiosk now. SIGTERM must be sent to a kiosk that draws frames.
until [ "$seen" != none ]; do
    watch
done
[ "$total" -gt 0 ] || fail 'no frame was counted' "$work/err"
kill -TERM "$kiosk_pid"
end_of_kiosk 30
check_end 'SIGTERM at the end'
echo "  ok    on a screen: $(cat "$work/output"), $total frames, quit and started again $quits times, SIGTERM ends it"
