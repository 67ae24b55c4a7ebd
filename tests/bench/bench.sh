#!/bin/bash
# bench.sh -- measures the kiosk on this machine and prints one row for each figure with its
# command.
# BUILD is the folder that make uses. Prints a table and writes it to BUILD/bench.tsv. Needs a
# quiet machine, because other programs change the results; the script names them at the top. Takes
# about a minute.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../e2e/lib.sh"

tsv=$BUILD/bench.tsv
printf 'figure\tvalue\tcommand\n' >"$tsv"

row() { # FIGURE VALUE COMMAND
    printf '%s\t%s\t%s\n' "$1" "$2" "$3" >>"$tsv"
    printf '  %-46s %-34s %s\n' "$1" "$2" "$3"
}
# FILE PATTERN: Prints the text that the pattern matches after its \K, in the first matching line.
pick() {
    grep -oP -- "$2" "$1" | head -1
}

cpu=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1)
[ -n "$cpu" ] || cpu=$(uname -m)
echo "machine: $cpu, $(nproc) cores, $(awk '/MemTotal/ { printf "%.0f GiB", $2 / 1048576 }' /proc/meminfo);" \
    "$(. /etc/os-release && echo "$PRETTY_NAME"); load $(cut -d' ' -f1 /proc/loadavg)"

demo="kingyo --demo 20 --window 1280x720 --seed 2013"
"$BUILD/kingyo" --demo 20 --window 1280x720 --seed 2013 --shots "$work/shots" >"$work/demo" 2>/dev/null
row 'drawn by' "$(pick "$work/demo" 'drawn by +\K.*')" "$demo"
row 'a frame off screen, 300 fish: median, p99' "$(pick "$work/demo" 'median \K[0-9.]+ ms, p99 [0-9.]+ ms')" "$demo"
row 'one tick of the core' "$(pick "$work/demo" '[0-9.]+ ms(?= a tick)')" "$demo"

"$BUILD/tests/bench/bench_open" >"$work/open"
within=$?
read -r open_ms open_max_ms back_ms back_max_ms <"$work/open"
row "opening the championship's tank: median, max" "$open_ms, $open_max_ms ms" bench_open
row "and the default tank again: median, max" "$back_ms, $back_max_ms ms" bench_open
[ $within -eq 0 ] || row 'opening a tank' 'OVER ITS BOUND' 'bench_open'

open_screen
bot="kingyo --window 1280x720 --mode festival --poi bot --seed 2013"
"$BUILD/kingyo" --window 1280x720 --mode festival --poi bot --seed 2013 --data "$work/data" >"$work/bot" 2>&1 &
kiosk_pid=$!
sleep 3
xdotool key space # A round takes 60 s, and the figures cover its first 25 s.
sleep 25
kill -TERM "$kiosk_pid"
end_of_kiosk 20
row 'a frame on a screen, 300 fish: median, p99' "$(pick "$work/bot" 'median \K[0-9.]+ ms, p99 [0-9.]+ ms')" "$bot"
row 'the work of it, drawing and swap: median, p99' "$(pick "$work/bot" 'work: median \K[0-9.]+ ms, p99 [0-9.]+ ms')" "$bot"
row "the core's share of that work" "$(pick "$work/bot" 'the core \K[0-9.]+ %')" "$bot"

read -r first_ms peak_mib < <("$BUILD/tests/bench/bench_start" 5 "$BUILD/kingyo" --window 1280x720 --data "$work/data" 2>"$work/start.err")
row 'start to first frame, cold' "$first_ms ms" 'bench_start 5 kingyo --window 1280x720'
read -r first_ms peak_mib < <("$BUILD/tests/bench/bench_start" 5 "$BUILD/kingyo" --window 1280x720 --data "$work/data" 2>"$work/start.err")
row 'start to first frame, again' "$first_ms ms" 'bench_start 5 kingyo --window 1280x720'
row 'peak memory, renderer included' "$peak_mib MiB" 'bench_start 5 kingyo --window 1280x720'

if [ -x "$BUILD/tests/bench/bench_latency" ]; then
    frame_ms=$(pick "$work/bot" 'frames, median \K[0-9.]+') work_ms=$(pick "$work/bot" 'work: median \K[0-9.]+')
    "$BUILD/tests/bench/bench_latency" "$frame_ms" "$work_ms" >"$work/latency"
    within=$?
    sed -nE 's/^(.{26}) +([0-9.]+) +([0-9.]+) +([0-9.]+) ms +(.*)/\1\t\2, \3, \4 ms (\5)/p' "$work/latency" |
        while IFS=$'\t' read -r what figures; do
            row "${what%"${what##*[! ]}"}: median, p99, max" "$figures" "bench_latency $frame_ms $work_ms"
        done
    [ $within -eq 0 ] || row 'input to picture' 'OVER ITS BOUND' 'bench_latency'
fi

waits=$("$BUILD/tests/bench/bench_reports" 10 500)
row 'a USB report to its tick, 500 a second: median, p99' "$(grep -oP 'tick: median \K[0-9.]+ ms, p99 [0-9.]+ ms' <<<"$waits")" 'bench_reports 10 500'

size=$("$BUILD/tests/sizes" | awk '$1 == "core" || $1 == "scene" { printf "%s%s %d KiB", sep, $1, $2 / 1024; sep = ", " }')
row 'the state, and what is shown of it' "$size" 'make sizes'
row "the core's code and constants" "$(size -A "$BUILD/core.o" | awk '$1 ~ /^\.text/ { c += $2 } $1 ~ /^\.rodata/ { k += $2 }
    END { printf "%d KiB and %d KiB", c / 1024, k / 1024 }')" 'make sizes'
row 'the program, with its textures' "$(stat -c %s "$BUILD/kingyo" | awk '{ printf "%.1f MiB", $1 / 1048576 }') unstripped" 'make build'
