#!/bin/bash
# figures_2005.sh -- makes figures 3.2 to 3.9 and 4.1 to 4.15 of the 2005 thesis from our own
# species, with commands that every user can run. Writes pictures, tables and a page into
# $BUILD/thesis-2005. Figure 3.1 is omitted, because it morphs a person into a pig.
set -eu
build=${BUILD:-build}
out=$build/thesis-2005
here=$(dirname "$0")
bin=$build/tests/thesis
begin=$SECONDS
mkdir -p "$out"
rm -f "$out"/*.png "$out"/*.svg "$out"/*.csv "$out"/*.tsv "$out"/*.html

say() { printf '[%3d s] %s\n' $((SECONDS - begin)) "$*"; }
# figure FILE CAPTION WHAT_WE_DO adds a line to the page after the picture was made. $made
# describes how it was made.
made=
figure() {
    [ -s "$out/$1.png" ]
    printf '%s\t%s\t%s\t%s\n' "$1" "$2" "$3" "$made" >>"$out/figures.tsv"
}
vector() { # FILE SUBCOMMAND SPECIES WORDS...: Kingyoctl draws the picture as SVG.
    made="kingyoctl morph ${*:2} --svg FILE.svg"
    "$build/kingyoctl" morph "${@:2}" --svg "$out/$1.svg"
    rsvg-convert "$out/$1.svg" -o "$out/$1.png"
}
sheet() { # FILE SPECIES WORDS...: Draws the sheet of a species with kingyoctl.
    made="kingyoctl morph export ${*:2} --sheet FILE.png"
    "$build/kingyoctl" morph export "${@:2}" --sheet "$out/$1.png"
}
stages() { # FILE KIND SPECIES: Draws a picture with tests/thesis/stages.c.
    made="build/tests/thesis/stages $2 $3 FILE.png"
    "$bin/stages" "$2" "$3" "$out/$1.png"
}

# Prints the English name of the species as the kiosk shows it, such as "Black conger".
name() { sed -n "s/^fish_$1 = //p" assets/text/en.txt | grep .; }

say 'chapter 3: path of a vertex (figures 3.2 to 3.5)'
vector figure-3.2 path kurodai --part dorsal --template ordinary
figure figure-3.2 'Ordinary morph: a vertex goes straight' 'Same: the root of the dorsal fin goes along the chord, to the last digit.'
stages figure-3.3 growth kurodai
figure figure-3.3 'How fish grow: the root of the dorsal fin' 'Same idea, with our drawings and where the fin begins in each.'
vector figure-3.4 path kurodai --part dorsal --template smooth
figure figure-3.4 'The ideal way of the vertex' 'The thesis draws it by hand; here it is what the smooth template does, without a corner at any key.'
vector figure-3.5 path kurodai --part dorsal
figure figure-3.5 "The method's way" "Better: fins ride on the body by body coordinates, so the root stays in the skin between keys, too, which straight pieces do not."

say 'section 3.2: the growth curve of the bigeye (figure 3.6)'
made='kingyoctl morph growth mebachi'
"$build/kingyoctl" morph growth mebachi --to-days 5479 --steps 600 >"$out/figure-3.6.csv"
"$build/kingyoctl" morph growth mebachi --to-days 730.5 --steps 400 >"$out/figure-3.6-young.csv"
gnuplot -e "dir='$out'" "$here/plots_2005.gp"
figure figure-3.6 "Growth curve: $(name mebachi)" 'Better: the plain curve hatches at 32 cm and the shifted one has lost 26 cm by the first birthday; ours begins true and is within 2.5 cm of the plain one by then.'

say 'section 3.3: deformation graphs (figures 3.7 to 3.9)'
vector figure-3.7 graph kuroanago
figure figure-3.7 'A deformation graph' 'Better: any number of keys, ages and lengths along the axis, and a size that may also fall: this conger shrinks as it leaves its leaf form.'
vector figure-3.8 graph kurodai --thesis --template pairwise
figure figure-3.8 'Template: two keys at a time' 'Same.'
vector figure-3.9 graph kurodai --thesis --template simultaneous
figure figure-3.9 'Template: three keys at once' 'Same peak of 70 %; smooth between knots, since straight pieces and a middle key solved for them would be the pairwise way again.'

say 'chapter 4: four fish'
fish() { # SPECIES MODELS GRAPH SHEET WORDS: Draws the figures 4.MODELS, 4.GRAPH and 4.SHEET.
    local name
    name=$(name "$1")
    stages "figure-4.$2" models "$1"
    figure "figure-4.$2" "Input models: $name" "$5"
    vector "figure-4.$3" graph "$1" --thesis
    figure "figure-4.$3" "Deformation graph: $name" 'Same keys and template.'
    vector "figure-4.$3-ours" graph "$1"
    figure "figure-4.$3-ours" "Deformation graph: $name, ours" 'Better: goes on to the adult.'
    sheet "figure-4.$4" "$1" --thesis
    figure "figure-4.$4" "Output: $name" "The thesis' method on our drawings: straight paths, and as long at these ages as its shifted growth curve makes them."
    sheet "figure-4.$4-ours" "$1"
    figure "figure-4.$4-ours" "Output: $name, ours" 'Better: grows to the adult, colours change with it, fins and eyes ride on the skin.'
}
fish kurodai 1 2 3 'Same stages: 1.9, 5.5 and 12.0 mm.'
stages figure-4.4 sizes shimafugu
figure figure-4.4 "Stages: $(name shimafugu)" 'Same stages, at one scale: 2.65, 12.2 and 25.8 mm.'
fish shimafugu 5 6 7 'Same stages.'
fish kuroanago 8 9 10 'Same stages: 64.0, 80.4 and 72.5 mm.'
stages figure-4.11 sizes hirame
figure figure-4.11 "Stages: $(name hirame)" 'Same three stages, at one scale; all lengths are standard lengths, which the thesis mixes with a total one.'
fish hirame 12 13 14 "Better: the maker draws the true middle stage; the exaggerated one, whose eye stands out of the head, is solved from it."
vector figure-4.13-eye graph hirame --curve eye
figure figure-4.13-eye "Deformation graph: the eye's own" 'Better: a part may have a curve of its own, which the thesis names as future work.'
stages figure-4.14-three-ways ways hirame
figure figure-4.14-three-ways "Output: $(name hirame), three ways" "The ordinary morph leads the eye through the head, the thesis' method sinks it half in on its way, ours keeps it on the skin."
vector figure-4.15 path hirame --part eye --thesis --view front
figure figure-4.15 'What three shapes can reach' 'Same: the triangle, the red way inside it; dotted the ideal way, which lies outside, as our method goes it.'
vector figure-4.15-ours path hirame --part eye --view front
figure figure-4.15-ours 'The eye by our own method' 'Better: it is a rigid part that rides round the head by body coordinates.'

say 'cases that the thesis omits'
sheet beyond-ray ray
figure beyond-ray "$(name ray)" 'The flat body form that chapter 4 leaves to the flounder, which is flattened the other way.'
sheet beyond-wakin wakin
figure beyond-wakin 'The goldfish of the stall' 'From its yolk over the dark months to red: colours grow, too.'
sheet beyond-mebachi mebachi
figure beyond-mebachi "$(name mebachi), the fish of figure 3.6" 'The fish of the growth curve, from 6 mm to 1.5 m.'

say 'the page'
"$here/page_2005.sh" "$out" >"$out/index.html"
say "done: $(wc -l <"$out/figures.tsv") figures in $out/index.html"
