#!/bin/bash
# figures.sh -- repeats the 2013 thesis' experiments with our tank: pictures, CSV and one page that shows
# them, in $BUILD/thesis. Each step says what it does and which words of `kingyoctl tank` anyone may run.
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
tank --preset festival --seconds 8 --poi-path "$here/escape_path.csv" --trace "$out/fright.csv" --trace-every 10
{
    echo 'tail_hz,lengths_per_s,gait'
    awk -F, -v OFS=, 'FNR > 1 && $1 > 0 && $14 != "held" && (FNR % 5 == 0 || $13 > 4.5) { print $13, $12 / $9, $14 }' \
        "$out/calm.csv" "$out/fright.csv"
} >"$out/beats.csv"
{
    echo 'tail_hz,speed_cm_s,gait'
    awk -F, -v OFS=, 'FNR > 1 && $1 > 0 && $9 > 4.4 && $9 < 4.8 && $14 != "held" { print $13, $12, $14 }' "$out/fright.csv"
} >"$out/beats_46.csv"
rm "$out/calm.csv" "$out/fright.csv"

say 'chapter 2: oxygen by temperature (figure 2.9)'
"$bin/curves" >"$out/figure-2.9.csv"

say 'chapter 4: pictures (figures 4.1 to 4.24)'
"$bin/pictures" "$out"

say 'chapter 4: updates a second (table 4.2)'
"$bin/table" "$out/table-4.2.csv"

say 'plots'
gnuplot -e "dir='$out'" "$here/plots.gp"

say 'the page'
"$here/page.sh" "$out" >"$out/index.html"
say "done: $out/index.html"
