# technique.gp -- draws the seven experiments on technique as a forest plot, from DIR/technique.tsv.
# Usage: gnuplot -e "dir='DIR'" technique.gp
set datafile separator '\t'
set terminal pngcairo size 1360,640 font 'Sans,15' background rgb '#fbfaf8'
set output dir.'/technique.png'
tsv = dir.'/technique.tsv'
stats tsv using 7 skip 1 nooutput name 'HIGH'
stats tsv using 6 skip 1 nooutput name 'LOW'
stats tsv using 2 skip 1 nooutput name 'SEEDS'
n = HIGH_records
right = HIGH_max > 0.5 ? HIGH_max * 1.08 : 0.5
left = LOW_min < 0 ? LOW_min * 1.15 : -0.06 * right
set label 1 sprintf('What technique is worth: festival, 300 fish, No. 6 paper, at most 60 s, %d paired seeds', int(SEEDS_max)) at screen 0.5,0.95 center font 'Sans,17'
set xlabel 'fish per poi that the better technique catches more: mean and 95 % confidence'
set border 1 lc rgb '#555555' lw 1.2
set tics nomirror textcolor rgb '#333333'
set grid xtics lc rgb '#dddddd' lw 1 lt 1
set xrange [left:right + 0.62 * (right - left)]
set yrange [n - 0.4:-0.6]
unset ytics; unset key
set lmargin 36; set rmargin 2; set tmargin 4
set arrow from 0,graph 0 to 0,graph 1 nohead lc rgb '#888888' lw 1.5 dt 2 back
colour(verdict) = verdict eq 'pays' ? 0x1f8f5f : verdict eq 'WRONG WAY' ? 0xc8371f : 0x999999
row(a, b, p, verdict) = sprintf('%.2f over %.2f, %s', a, b, verdict eq 'pays' ? sprintf('p = %.0e', p) : verdict)
plot tsv using 5:0:6:7:(colour(strcol(9))) skip 1 with xerrorbars pt 7 ps 1.6 lw 3 lc rgb variable, \
     '' using (left):0:1 skip 1 with labels right offset -1.5,0 textcolor rgb '#333333', \
     '' using (right):0:(row($3, $4, $8, strcol(9))) skip 1 with labels left offset 1,0 textcolor rgb '#555555'
