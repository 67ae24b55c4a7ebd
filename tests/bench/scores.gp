# scores.gp -- draws the catches of bots and the known catches of people, from DIR/scores.tsv.
# Usage: gnuplot -e "dir='DIR'" scores.gp
set datafile separator '\t'
set terminal pngcairo size 1280,960 font 'Sans,15' background rgb '#fbfaf8'
set output dir.'/scores.png'
tsv = dir.'/scores.tsv'
set border 3 lc rgb '#555555' lw 1.2
set tics nomirror textcolor rgb '#333333'
set grid ytics lc rgb '#dddddd' lw 1 lt 1
set style fill solid 0.9 noborder
set ylabel 'rounds'
unset key
set yrange [0:*]
people = '#c8371f'
# The axes of the novices are fixed, because gnuplot would fit them to all rows. A novice catches fewer
# than twenty fish. of() is 1 for a round of the bot and tank `arm`, and 0 for all other rows.
of(arm) = strcol(1) eq arm ? 1 : 0
bin(x, width) = width * floor(x / width) + 0.5 * width
set multiplot layout 3,1 title "Fish caught in a round: bots (bars), and what people are known to catch (behind them)\n"

set xrange [-0.6:20.6]
set xtics 1
set boxwidth 0.8
set title 'festival, No. 6 paper: the novice, and the two or three that most people are content with'
set object 1 rectangle from 1.5,graph 0 to 3.5,graph 1 fc rgb people fs solid 0.15 noborder behind
plot tsv using 3:(of('festival novice')) skip 1 smooth frequency with boxes lc rgb '#d9902f'

set title 'championship, No. 5 paper: the novice, and the one or two of a first-timer'
set object 1 rectangle from 0.5,graph 0 to 2.5,graph 1
plot tsv using 3:(of('championship novice')) skip 1 smooth frequency with boxes lc rgb '#d9902f'

set title 'championship, No. 5 paper: the expert, the 35 to 87 of winners, and the record of 107'
set xlabel 'fish caught'
set xrange [0:125<*]
set xtics 10
set boxwidth 4.4
set object 1 rectangle from 35,graph 0 to 87,graph 1
set arrow 1 from 107,graph 0 to 107,graph 1 nohead lc rgb people lw 2 dt 2
plot tsv using (bin($3, 5)):(of('championship expert')) skip 1 smooth frequency with boxes lc rgb '#1f6f9f'
unset multiplot
