#!/bin/bash
# page.sh FOLDER -- prints the HTML page with the results of figures.sh.
set -eu
out=$1

figure() { # FILE CAPTION [CSV]: Prints one figure of the page, with a link to its CSV.
    printf '<figure><a href="%s"><img src="%s" alt=""></a><figcaption>%s' "$1" "$1" "$2"
    [ $# -gt 2 ] && printf ' <a href="%s">CSV</a>' "$3"
    printf '</figcaption></figure>\n'
}
pictures() { # FIRST LAST: Prints figures 4.FIRST to 4.LAST.
    awk -F'\t' -v first="$1" -v last="$2" '{ split($1, n, "."); if (n[2] < first || n[2] > last) next
        printf "<figure><a href=\"%s\"><img src=\"%s\" alt=\"\"></a><figcaption><b>%s</b> at %s: %s</figcaption></figure>\n",
            $2, $2, $1, $3, $4 }' "$out/pictures.tsv"
}
words() { # NUMBER: Prints the command that drew figure NUMBER.
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
echo '<h2>Chapter 2: behaviour of real goldfish</h2><div class="row">'
figure figure-2.1.png 'Tail beat frequency and speed. The points are our fish that swim, burst or escape.' beats.csv
figure figure-2.2.png 'Tail beat frequency and speed of fish of 4.6 cm.' beats_46.csv
[ -f "$out/figure-2.3.png" ] && figure figure-2.3.png 'Position of a single fish along a tank of 60 x 30 cm.' figure-2.3.csv
figure figure-2.9.png 'Oxygen saturation, and the oxygen consumption of 100 g of goldfish.' figure-2.9.csv
echo '</div><h2>4.1 Avoidance</h2>'
for name in '1 4 head_on' '5 8 side' '9 12 rear_end'; do
    read -r first last csv <<<"$name"
    words "4.$first"
    echo '<div class="row four">'
    pictures "$first" "$last"
    printf '</div><p><a href="%s.csv">positions of both fish (CSV)</a></p>\n' "$csv"
done
[ -f "$out/gap.png" ] && { echo '<div class="row">'; figure gap.png 'Boxes avoid only fish that come within 3 cm. Balls avoid fish that would pass at 8.5 cm.' gap.csv; echo '</div>'; }
echo '<h2>600 fish after 10 s</h2>'
words 4.13
echo '<div class="row">'
pictures 13 16
echo '</div><p><a href="crowd.csv">positions of all fish (CSV)</a></p><h2>4.2 Shade</h2>'
words 4.17
echo '<div class="row">'
pictures 17 20
figure shade.png 'Fish in the shade for each second.' shade.csv
echo '</div><h2>4.3 Surface breathing</h2>'
words 4.21
echo '<div class="row">'
pictures 21 24
figure gulping.png 'Fish at the surface for each second.' gulping.csv
echo '</div><h2>4.4 Speed</h2>'
sed -n '1s/^# \(.*\)/<p>\1<\/p>/p' "$out/table-4.2.csv"
echo '<div class="row"><table><tr><th>fish</th><th>thesis, grid</th><th>thesis, all pairs</th><th>ours, grid</th>'
echo '<th>ours, all pairs</th><th>grid, not drawn</th><th>all pairs, not drawn</th></tr>'
awk -F, 'NR > 2 { printf "<tr><td>%s</td><td>%s</td><td>%s</td><td>%s</td><td>%s</td><td>%s</td><td>%s</td></tr>\n",
    $1, $2, $3 == "" ? "not measurable" : $3, $8, $9, $10, $11 }' "$out/table-4.2.csv"
echo '</table>'
figure table-4.2.png 'Updates per second (median of 15). An update is a tick and a picture. Our pictures take a thousand times as long as our ticks, so the search for near fish affects only the figures without drawing.' table-4.2.csv
echo '</div></body></html>'
