#!/bin/bash
# page_2005.sh FOLDER -- prints the HTML page with the results of figures_2005.sh.
set -eu
cat <<'HTML'
<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Kingyo: the 2005 thesis, repeated</title><style>
body { font: 16px/1.5 sans-serif; color: #333; background: #fbfaf8; max-width: 1320px; margin: 2em auto; padding: 0 1em; }
h1 { font-weight: 600; color: #a32a14; } code { background: #f0ece6; padding: 0.1em 0.4em; font-size: 13px; }
.row { display: grid; grid-template-columns: repeat(auto-fill, minmax(600px, 1fr)); gap: 28px 16px; align-items: start; }
figure { margin: 0; } img { width: 100%; border: 1px solid #e4dfd8; border-radius: 4px; } figcaption { font-size: 14px; }
</style></head><body>
<h1>The 2005 thesis, repeated with our species</h1>
<p>Every figure is made by <code>make thesis-figures</code>. Figure 3.1, a person who becomes a pig, is outside.</p>
<div class="row">
HTML
awk -F'\t' '{ number = $1; sub(/^figure-/, "", number); sub(/^beyond-.*/, "Beyond:", number)
    printf "<figure><a href=\"%s.png\"><img src=\"%s.png\" alt=\"\"></a><figcaption><b>%s %s.</b> %s<br><code>%s</code></figcaption></figure>\n",
        $1, $1, number, $2, $3, $4 }' "$1/figures.tsv"
echo '</div></body></html>'
