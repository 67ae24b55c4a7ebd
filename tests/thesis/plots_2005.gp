# plots_2005.gp -- figure 3.6 of the 2005 thesis: the growth of the bigeye tuna, three ways.
# gnuplot -e "dir='build/thesis-2005'" plots_2005.gp
set datafile separator ','
set terminal pngcairo size 1280,720 font 'Sans,16' background rgb '#fbfaf8'
set border 3 lc rgb '#555555' lw 1.2
set tics nomirror textcolor rgb '#333333'
set grid lc rgb '#dddddd' lw 1 lt 1
red = '#c8371f'; blue = '#1f6f9f'; grey = '#888888'
old = dir.'/figure-3.6.csv'
young = dir.'/figure-3.6-young.csv'

set output dir.'/figure-3.6.png'
set multiplot
set title 'Figure 3.6  Growth of the bigeye tuna: three ways'
set xlabel 'age (years)'; set ylabel 'fork length (cm)'
set xrange [0:15]; set yrange [0:210]
set key left top reverse Left samplen 2 textcolor rgb '#333333'
plot old using 2:($4 / 10) skip 1 with lines lw 3 lc rgb grey title 'von Bertalanffy as fitted (eq. 3.3)', \
     '' using 2:($5 / 10) skip 1 with lines lw 3 dt 2 lc rgb blue title "its start shifted (section 3.2)", \
     '' using 2:($3 / 10) skip 1 with lines lw 4 lc rgb red title 'ours'
unset title; unset key; unset object
set size 0.47, 0.52; set origin 0.50, 0.14
set object 1 rectangle from graph -0.20, graph -0.24 to graph 1.04, graph 1.10 behind fillcolor rgb '#fbfaf8' fillstyle solid noborder
set xlabel 'the first two years' offset 0, 0.4; unset ylabel
set xrange [0:2]; set yrange [0:100]; set xtics 0.5; set ytics 25
replot
unset multiplot
