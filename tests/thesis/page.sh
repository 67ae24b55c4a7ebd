#!/bin/bash
# page.sh FOLDER -- the page that shows what figures.sh made, on standard output.
set -eu
out=$1

figure() { # FILE CAPTION [CSV]
    printf '<figure><a href="%s"><img src="%s" alt=""></a><figcaption>%s' "$1" "$1" "$2"
    [ $# -gt 2 ] && printf ' <a href="%s">CSV</a>' "$3"
    printf '</figcaption></figure>\n'
}
pictures() { # FIRST LAST: figures 4.FIRST to 4.LAST
    awk -F'\t' -v first="$1" -v last="$2" '{ split($1, n, "."); if (n[2] < first || n[2] > last) next
        printf "<figure><a href=\"%s\"><img src=\"%s\" alt=\"\"></a><figcaption><b>%s</b> at %s: %s</figcaption></figure>\n",
            $2, $2, $1, $3, $4 }' "$out/pictures.tsv"
}
words() { # NUMBER: what was run for that picture
    awk -F'\t' -v number="$1" '$1 "" == number "" { printf "<p><code>kingyoctl tank %s</code></p>\n", $5 }' "$out/pictures.tsv"
}

cat <<'HTML'
<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Kingyo: the 2013 thesis, repeated</title><style>
body { font: 16px/1.5 sans-serif; color: #333; background: #fbfaf8; max-width: 1320px; margin: 2em auto; padding: 0 1em; }
h1, h2 { font-weight: 600; color: #a32a14; } code { background: #f0ece6; padding: 0.1em 0.4em; }
.row { display: grid; grid-template-columns: repeat(auto-fill, minmax(600px, 1fr)); gap: 12px; }
.four { grid-template-columns: repeat(4, 1fr); } figure { margin: 0; } img { width: 100%; border-radius: 4px; }
figcaption { font-size: 13px; color: #555; } table { border-collapse: collapse; } td, th { padding: 0.2em 1em; text-align: right;
border-bottom: 1px solid #ddd; }
</style></head><body>
<h1>The 2013 thesis, repeated with our tank</h1>
<p>Every figure is made by <code>make thesis-figures</code>. Pictures are drawn by the kiosk's own renderer.</p>
HTML
echo '<h2>Chapter 2: what real goldfish do</h2><div class="row">'
figure figure-2.1.png 'Tail beat and speed; points are our fish, swimming, bursting and escaping.' beats.csv
figure figure-2.2.png 'The same for fish of 4.6 cm.' beats_46.csv
[ -f "$out/figure-2.3.png" ] && figure figure-2.3.png 'Where a single fish is along a tank of 60 x 30 cm.' figure-2.3.csv
figure figure-2.9.png 'Saturation, and what 100 g of goldfish breathe.' figure-2.9.csv
echo '</div><h2>4.1 Giving way</h2>'
for name in '1 4 head_on' '5 8 side' '9 12 rear_end'; do
    read -r first last csv <<<"$name"
    words "4.$first"
    echo '<div class="row four">'
    pictures "$first" "$last"
    printf '</div><p><a href="%s.csv">where both were, CSV</a></p>\n' "$csv"
done
[ -f "$out/gap.png" ] && { echo '<div class="row">'; figure gap.png 'Boxes give way only to what comes within 3 cm; balls to what would pass 8.5 cm away.' gap.csv; echo '</div>'; }
echo '<h2>600 fish after 10 s</h2>'
words 4.13
echo '<div class="row">'
pictures 13 16
echo '</div><p><a href="crowd.csv">where all of them are, CSV</a></p><h2>4.2 Shade</h2>'
words 4.17
echo '<div class="row">'
pictures 17 20
figure shade.png 'Second by second.' shade.csv
echo '</div><h2>4.3 Gulping</h2>'
words 4.21
echo '<div class="row">'
pictures 21 24
figure gulping.png 'Second by second.' gulping.csv
echo '</div><h2>4.4 Speed</h2>'
sed -n '1s/^# \(.*\)/<p>\1<\/p>/p' "$out/table-4.2.csv"
echo '<div class="row"><table><tr><th>fish</th><th>thesis, grid</th><th>thesis, all pairs</th><th>ours, grid</th>'
echo '<th>ours, all pairs</th><th>grid, not drawn</th><th>all pairs, not drawn</th></tr>'
awk -F, 'NR > 2 { printf "<tr><td>%s</td><td>%s</td><td>%s</td><td>%s</td><td>%s</td><td>%s</td><td>%s</td></tr>\n",
    $1, $2, $3 == "" ? "not measurable" : $3, $8, $9, $10, $11 }' "$out/table-4.2.csv"
echo '</table>'
figure table-4.2.png 'Updates a second; an update is a tick and a picture, and the median of 15. Our pictures take a thousand times as long as our ticks, so how near fish are found shows only where nothing is drawn.' table-4.2.csv
echo '</div></body></html>'
