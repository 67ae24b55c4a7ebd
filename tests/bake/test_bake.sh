#!/bin/bash
# test_bake.sh -- the bake rejects wrong words and fonts with one line that gives the position.
# Speaks TAP.
# The same sources give the same bytes, and the caustics have no seam in space or time.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
bake=$build/bake

fresh() {
    rm -rf "$work/text"
    cp -r assets/text "$work/text"
}

# Expects exit 65 and exactly one line that matches PATTERN.
refuses() { # PATTERN TEXT
    local output status
    output=$("$bake" font "$work/text" "$work/a.bin" "$work/a.c" "$work/a.h" 2>&1)
    status=$?
    [ $status -eq 65 ] && [ "$(wc -l <<<"$output")" -eq 1 ] && grep -qE -- "$1" <<<"$output"
    status=$?
    ok $status "$2"
    [ $status -eq 0 ] || sed 's/^/# /' <<<"$output"
}

fresh
echo 'extra = 余分' >>"$work/text/ja.txt"
refuses 'en.txt lacks `extra`, which is at .*ja.txt:[0-9]+' 'a key that only Japanese has is reported'

fresh
sed -i '/^title/d' "$work/text/ja.txt"
refuses 'ja.txt lacks `title`, which is at .*en.txt:2' 'a key that only English has is reported'

fresh
echo 'title = again' >>"$work/text/en.txt"
refuses 'en.txt:[0-9]+: `title` is already on line 2' 'a duplicate key is reported'

fresh
echo 'no equals sign' >>"$work/text/en.txt"
refuses 'en.txt:[0-9]+: expected `key = words`' 'a line without words is reported'

fresh
printf 'odd = \xff\xfe\n' >>"$work/text/en.txt"
refuses 'en.txt:[0-9]+: `odd` holds bytes that are not UTF-8' 'invalid UTF-8 is reported'

fresh
sed -i 's/^unit = .*/unit = 𒀀/' "$work/text/ja.txt"
line=$(grep -n '^unit' "$work/text/ja.txt" | cut -d: -f1)
refuses "font body .* lacks .𒀀. \(U\+12000\), which .*ja.txt:$line uses" \
    'a character that no font has is named with its font, file and line'

fresh
sed -i 's/ReggaeOne/Nowhere/' "$work/text/fonts.txt"
refuses 'font stall: cannot read .*Nowhere-Regular.ttf: .*' 'a missing font file is reported'

fresh
sed -i 's/OpenSans-Bold/OpenSans-Nowhere/' "$work/text/fonts.txt"
refuses 'font body: cannot read .*OpenSans-Nowhere.ttf: .*' 'a missing Latin font file is reported'

fresh
sed -i "s|/usr[^ ]*ReggaeOne[^ ]*|$work/text/en.txt|" "$work/text/fonts.txt"
refuses 'font stall: .*en.txt is not a TrueType font' 'a file that is not a font is reported'

fresh
sed -i -E 's/^brush 128/brush 256/' "$work/text/fonts.txt"
refuses 'fonts.txt: [0-9]+ glyphs fill 3 pages of 2048x2048 texels, and FONT_PAGES_MAX is 2' \
    'more glyphs than fit a texture that every driver takes are refused'

for asset in caustics patterns environment wood paper; do
    "$bake" $asset "$work/$asset" >/dev/null && cmp -s "$work/$asset" "$build/generated/$asset.bin"
    ok $? "$asset is identical byte for byte in a second bake"
done

"$bake" caustics /nowhere/at/all 2>"$work/log" >/dev/null
[ $? -eq 65 ] && grep -q 'cannot write /nowhere/at/all' "$work/log"
ok $? 'an output that cannot be written is reported'

"$bake" nonsense "$work/x" >/dev/null 2>&1
[ $? -eq 2 ]
ok $? 'an unknown asset is wrong usage'

# ---- The list of refused player names
refuses_words() { # LINE PATTERN TEXT
    printf '# a list\nfuck\n%s\n' "$1" >"$work/refused.txt"
    "$bake" words "$work/refused.txt" "$work/words.c" >/dev/null 2>"$work/log"
    [ $? -eq 65 ] && [ "$(wc -l <"$work/log")" -eq 1 ] && grep -qE -- "$2" "$work/log"
    ok $? "$3"
}
refuses_words '...' 'refused.txt:3: a word has 1 to 16 letters' 'a refused name without a letter is reported'
refuses_words 'abcdefghijklmnopq' 'refused.txt:3: a word has 1 to 16' 'a refused name that is too long is reported'
refuses_words 'as' 'refused.txt:3: .*write =word' 'a refused name of two letters must be marked as a whole name'
refuses_words "$(printf 'x%.0s' {1..300})" 'refused.txt:3: a word has 1 to 16' 'a line that is too long is reported'
printf '# none\n' >"$work/refused.txt"
"$bake" words "$work/refused.txt" "$work/words.c" >/dev/null 2>&1
[ $? -eq 65 ]
ok $? 'an empty list of refused names is rejected'
"$bake" words assets/words/refused.txt "$work/words.c" >/dev/null && cmp -s "$work/words.c" "$build/generated/refused_words.c"
ok $? 'the list of refused names is identical in a second bake'

# The differences across the seams (last to first column, row and frame) are no larger than other
# differences.
od -An -v -tu1 -w256 "$work/caustics" | awk '
    { seam_x += ($1 - $256) ^ 2; inner_x += ($128 - $129) ^ 2; frame = int((NR - 1) / 256); row = (NR - 1) % 256
      v = $40; col[frame, row] = v
      if (row == 255) { seam_y += (col[frame, 0] - v) ^ 2; inner_y += (col[frame, 127] - col[frame, 128]) ^ 2 } }
    END { frames = frame + 1
      for (r = 0; r < 256; r++) { seam_t += (col[frames - 1, r] - col[0, r]) ^ 2; inner_t += (col[5, r] - col[6, r]) ^ 2 }
      printf "# squared steps: x %d of %d, y %d of %d, time %d of %d\n", seam_x, inner_x, seam_y, inner_y, seam_t, inner_t
      exit !(seam_x < 2 * inner_x && seam_y < 2.5 * inner_y && seam_t < 3 * inner_t) }'
ok $? 'the caustics continue across every edge and at the end of the loop'

echo "1..$count"
