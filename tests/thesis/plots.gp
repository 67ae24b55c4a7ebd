# plots.gp -- figures of chapter 2 and the counts of chapter 4 from the CSV files beside them.
# gnuplot -e "dir='build/thesis'" plots.gp
set datafile separator ','
set terminal pngcairo size 1280,720 font 'Sans,16' background rgb '#fbfaf8'
set border 3 lc rgb '#555555' lw 1.2
set tics nomirror textcolor rgb '#333333'
set grid lc rgb '#dddddd' lw 1 lt 1
set key left top reverse Left samplen 2 textcolor rgb '#333333'
red = '#c8371f'; blue = '#1f6f9f'; grey = '#888888'; gold = '#d9902f'
csv(name) = dir.'/'.name

set output csv('figure-2.1.png')
set title 'Figure 2.1  Speed in body lengths follows the tail beat'
set xlabel 'tail beat f (Hz)'; set ylabel 'speed U / L (1/s)'
set xrange [0:14]; set yrange [0:10]
plot 0.6 * x lw 3 lc rgb grey title 'U / L = 0.6 f  (equations 2.1 and 2.2)', \
     (3 * x - 4) / 4 lw 2 dt 2 lc rgb blue title 'U / L = (3 f - 4) / 4  (Bainbridge 1958)', \
     csv('beats.csv') using 1:2 with points pt 7 ps 0.5 lc rgb '#50c8371f' title 'our fish: swimming, bursting, escaping'

set output csv('figure-2.2.png')
set title 'Figure 2.2  A goldfish of 4.6 cm'
set xlabel 'tail beat f (Hz)'; set ylabel 'speed U (cm/s)'
set xrange [0:14]; set yrange [0:50]
plot 0.6 * x * 4.6 lw 3 lc rgb grey title 'U = 0.6 f L', \
     4.6 * (3 * x - 4) / 4 lw 2 dt 2 lc rgb blue title 'Bainbridge 1958', \
     csv('beats_46.csv') using 1:2 with points pt 7 ps 0.6 lc rgb '#30c8371f' title 'our fish of 4.6 cm'

set output csv('figure-2.3.png')
set title 'Figure 2.3  Where a single fish is along a tank of 60 x 30 cm'
set xlabel 'place along the tank (cm)'; set ylabel 'share of its time in each 2 cm'
set xrange [0:60]; set yrange [0:*]; set style fill solid 0.85 noborder; set boxwidth 1.7; set key center top
plot csv('figure-2.3.csv') using 1:2 skip 1 with boxes lc rgb red title 'walls draw it (--wall-follow 1)', \
     '' using 1:3 skip 1 with steps lw 2 lc rgb blue title 'they do not', \
     1 / 30.0 lw 2 dt 2 lc rgb grey title 'everywhere alike'

set output csv('figure-2.9.png')
set title 'Figure 2.9  What water holds, and what 100 g of goldfish breathe'
set xlabel 'water temperature (°C)'; set ylabel 'dissolved oxygen at saturation (mg/L)'
set y2label 'oxygen breathed (mg/h)'; set y2tics textcolor rgb '#333333'; set border 11
set xrange [0:40]; set yrange [0:16]; set y2range [0:*]; set key center top
plot csv('figure-2.9.csv') using 1:2 skip 1 with lines lw 3 lc rgb blue title 'held at 1013.25 hPa', \
     '' using 1:3 skip 1 with lines lw 2 dt 2 lc rgb blue title 'held at 900 hPa', \
     '' using 1:4 skip 1 axes x1y2 with lines lw 3 lc rgb red title 'breathed by 100 g of 5 cm fish (right)', \
     '' using 1:5 skip 1 axes x1y2 with lines lw 2 dt 2 lc rgb gold title 'breathed by one fish of 100 g (right)'
unset y2label; unset y2tics; set border 3; unset y2range

set output csv('gap.png')
set title 'Section 4.1  Two fish meet: spaces as boxes, and as the balls that hold them'
set xlabel 'their courses, apart (cm)'; set ylabel 'gap between the bodies as they pass (mm)'
set y2label 'strayed from their courses until past (mm)'; set y2tics textcolor rgb '#333333'; set border 11
set xrange [0:10]; set yrange [0:100]; set y2range [0:300]; set key top left
plot csv('gap.csv') using 1:2 skip 1 with linespoints pt 7 lw 3 lc rgb red title 'gap, boxes', \
     '' using 1:3 skip 1 with linespoints pt 7 lw 3 lc rgb blue title 'gap, balls', \
     '' using 1:4 skip 1 axes x1y2 with lines lw 2 dt 2 lc rgb red title 'strayed, boxes (right)', \
     '' using 1:5 skip 1 axes x1y2 with lines lw 2 dt 2 lc rgb blue title 'strayed, balls (right)', \
     10 * (x - 1) lw 1 dt 3 lc rgb grey title 'gap if nobody gave way'
unset y2label; unset y2tics; set border 3; unset y2range

set output csv('shade.png')
set title 'Figures 4.17 to 4.20  Fish within the shadow, second by second (200 fish)'
set xlabel 'time (s)'; set ylabel 'fish in the shade'; set xrange [0:20]; set yrange [0:*]; set key right bottom
plot csv('shade.csv') using 1:2 skip 1 with linespoints pt 7 lw 3 lc rgb red title 'within 10 cm of its middle', \
     200 * pi * 100 / (136 * 65.0) lw 2 dt 2 lc rgb grey title 'as many as chance puts there'

set output csv('gulping.png')
set title 'Figures 4.21 to 4.24  Fish that gulp at the surface (200 fish, stamina 20)'
set xlabel 'time (s)'; set ylabel 'fish at the surface'; set key right top
plot csv('gulping.csv') using 1:2 skip 1 with linespoints pt 7 lw 3 lc rgb red title 'mouths in the film'

set output csv('table-4.2.png')
set title 'Table 4.2  Updates a second'
set xlabel 'fish'; set ylabel 'updates a second'; set logscale y; set xrange [0:650]; set yrange [0.1:1e8]
set key right top; set format y '10^{%T}'
plot csv('table-4.2.csv') using 1:10 skip 2 with linespoints pt 7 lw 3 lc rgb red title 'ours, the tick alone', \
     '' using 1:11 skip 2 with linespoints pt 6 lw 2 dt 2 lc rgb red title 'each against each, the tick alone', \
     '' using 1:8 skip 2 with linespoints pt 7 lw 3 lc rgb gold title 'ours, with drawing', \
     '' using 1:9 skip 2 with linespoints pt 6 lw 2 dt 2 lc rgb gold title 'each against each, with drawing', \
     '' using 1:2 skip 2 with linespoints pt 7 lw 3 lc rgb grey title 'the thesis, with drawing', \
     '' using 1:3 skip 2 with linespoints pt 6 lw 2 dt 2 lc rgb grey title 'the thesis, each against each'
unset logscale y; unset format
