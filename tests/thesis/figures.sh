#!/bin/bash
# figures.sh -- repeats the experiments of the 2013 thesis with our tank. Writes pictures, CSV and
# a page into $BUILD/thesis. Each step prints its purpose and the `kingyoctl tank` command, which
# every user can run.
set -eu
build=${BUILD:-build}
out=$build/thesis
here=$(dirname "$0")
bin=$build/tests/thesis
begin=$SECONDS
mkdir -p "$out"
rm -f "$out"/*.png "$out"/*.csv "$out"/*.tsv "$out"/*.html

say() { printf '[%3d s] %s\n' $((SECONDS - begin)) "$*"; }
tank() { "$build/kingyoctl" tank "$@" >/dev/null; }

say 'chapter 2: tail beats against speed (figures 2.1, 2.2), from traces of calm and of frightened fish'
tank --preset thesis --fish 200 --seconds 20 --trace "$out/calm.csv" --trace-every 30
tank --preset festival --seconds 8 --poi-path "$here/escape_path.csv" --trace "$out/fright.csv" --trace-every 4
{
    echo 'tail_hz,lengths_per_s,gait'
    awk -F, -v OFS=, 'FNR > 1 && $1 > 0 && $14 != "held" && (FNR % 12 == 0 || $13 > 4.5 && FNR % 2 == 0) { print $13, $12 / $9, $14 }' \
        "$out/calm.csv" "$out/fright.csv"
} >"$out/beats.csv"
{
    echo 'tail_hz,speed_cm_s,gait'
    awk -F, -v OFS=, 'FNR > 1 && $1 > 0 && $9 > 4.4 && $9 < 4.8 && $14 != "held" { print $13, $12, $14 }' "$out/fright.csv"
} >"$out/beats_46.csv"
rm "$out/calm.csv" "$out/fright.csv"

say 'chapter 2: position of a single fish in 60 x 30 cm (figure 2.3): 24 fish with and 8 without wall following, an hour each'
# K FISH: K is the wall-following strength and FISH the number of fish. Prints the share of their
# time in each 2 cm of the tank's length.
lone() {
    # A fish follows one wall for minutes, so a simulated day is needed until both walls have equal
    # shares.
    seq "$2" | xargs -P "$(nproc)" -I{} "$build/kingyoctl" tank --preset festival --fish 1 --size-cm 60,20,30 --wall-follow "$1" \
        --seconds 3600 --seed {} --trace "$out/lone-$1-{}.trace" --trace-every 60 >"$out/lone.log"
    awk -F, 'FNR > 1 { bin = int(($3 + 30) / 2); seen[bin < 0 ? 0 : bin > 29 ? 29 : bin]++; all++ }
        END { for (bin = 0; bin < 30; bin++) printf "%d,%.5f\n", 2 * bin + 1, seen[bin] / all }' "$out/lone-$1"-*.trace
    rm "$out/lone-$1"-*.trace "$out/lone.log"
}
lone 1 24 >"$out/lone-drawn.csv"
lone 0 8 >"$out/lone-free.csv"
{
    echo 'x_cm,share_with_walls,share_without'
    paste -d, "$out/lone-drawn.csv" <(cut -d, -f2 "$out/lone-free.csv")
} >"$out/figure-2.3.csv"
rm "$out/lone-drawn.csv" "$out/lone-free.csv"
awk -F, 'NR > 1 { left += NR <= 16 ? $2 : 0; near += $1 < 10 || $1 > 50 ? $2 : 0 }
    END { printf "  figure 2.3: %.3f of the time in the left half, %.3f in the right, %.3f within 10 cm of an end\n", left, 1 - left, near }' \
    "$out/figure-2.3.csv"

say 'chapter 2: oxygen by temperature (figure 2.9)'
"$bin/curves" >"$out/figure-2.9.csv"

say 'section 4.1: passing distance of two fish with boxes and with balls'
"$bin/gaps" >"$out/gap.csv"

say 'chapter 4: pictures (figures 4.1 to 4.24)'
"$bin/pictures" "$out"

say 'chapter 4: updates a second (table 4.2)'
"$bin/table" "$out/table-4.2.csv"

say 'plots'
gnuplot -e "dir='$out'" "$here/plots.gp"

say 'the page'
"$here/page.sh" "$out" >"$out/index.html"
say "done: $out/index.html"
