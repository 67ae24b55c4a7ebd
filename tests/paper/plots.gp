# plots.gp -- gnuplot -e "dir='build/paper'" plots.gp: the paper's figures as SVG and PNG.
set encoding utf8
grades = "4 5 6 7"
colour(g) = g == 4 ? "#1b4f72" : g == 5 ? "#2e86c1" : g == 6 ? "#d68910" : "#c0392b"
# The membrane's formula: the speed at which the centre has its ultimate tension.
wet(g) = g == 4 ? 60 : g == 5 ? 45 : g == 6 ? 32 : 20
stiff(g) = g == 4 ? 2800 : g == 5 ? 2300 : g == 6 ? 2000 : 1600
formula(g) = sqrt(2 * (wet(g) / 0.423) ** 1.5 / sqrt(stiff(g)) / 0.04 / 1170)

do for [kind in "svg png"] {
    reset
    set style fill transparent solid 0.12 noborder
    set grid lw 0.5 lc "#cccccc"
    set border 3 lw 0.8
    set tics nomirror
    if (kind eq "svg") { set terminal svg size 1160,640 font "sans,15" background "#ffffff" } \
    else { set terminal pngcairo size 1160,640 font "sans,12" }

    set output dir."/tear.".kind
    set title "How long wet paper lasts, led broadside through water at one speed"
    set xlabel "speed, m/s"
    set ylabel "time to the first tear, s"
    set logscale xy
    set xrange [0.1:1.6]
    set yrange [0.007:20]
    set xtics (0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1, 1.2, 1.6)
    set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20)
    set key outside right top Left reverse spacing 1.2 samplen 2
    set arrow 1 from 0.1, 0.05 to 1.6, 0.05 nohead lc "#888888" dt 3
    set label 1 "instant: 0.05 s" at 0.102, 0.058 left tc "#666666"
    plot for [i = 1:4] dir."/tear.tsv" index (2 * i - 2) using 3:5:6 with filledcurves lc rgb colour(int(word(grades, i))) notitle, \
         for [i = 1:4] dir."/tear.tsv" index (2 * i - 1) using 3:5:6 with filledcurves lc rgb colour(int(word(grades, i))) notitle, \
         for [i = 1:4] dir."/tear.tsv" index (2 * i - 2) using 3:($4 < 100 ? $4 : NaN) with lines lw 2.5 lc rgb colour(int(word(grades, i))) title "No. ".word(grades, i).", all wet", \
         for [i = 1:4] dir."/tear.tsv" index (2 * i - 1) using 3:($4 < 100 ? $4 : NaN) with lines lw 2.5 dt 2 lc rgb colour(int(word(grades, i))) title "No. ".word(grades, i).", half wet", \
         for [i = 1:4] "+" using (formula(int(word(grades, i)))):(0.05) every ::0::0 with points pt 7 ps 1.1 lc rgb colour(int(word(grades, i))) title i == 4 ? "membrane formula, instant" : ""
    unset logscale; unset arrow; unset label

    set output dir."/force.".kind
    set title "What 0.3 m/s presses on the paper, by its tilt to the way"
    set xlabel "between paper and way, degrees"
    set ylabel "force on the paper, N"
    set xrange [0:90]
    set yrange [0:0.32]
    set xtics 15
    set ytics 0.05
    set key bottom right
    plot dir."/force.tsv" using 1:2 with lines lw 2.5 lc "#2e86c1" title "measured on the core", \
         0.5 * 1000 * 1.12 * 5.03e-3 * 0.09 * sin(x * pi / 180) ** 2 with lines dt 3 lc "#888888" title "naive: sin^2", \
         "+" using (90):(0.25):(0.025) every ::0::0 with yerrorbars pt 7 lc "#c0392b" title "0.25 N, within 10 %"

    if (kind eq "svg") { set terminal svg size 1000,1230 font "sans,15" background "#ffffff" } \
    else { set terminal pngcairo size 1000,1230 font "sans,12" }
    set output dir."/holes.".kind
    unset key; unset title; unset xlabel; unset ylabel; unset tics; unset border; unset grid
    set size ratio -1
    set xrange [-0.5:31.5]
    set yrange [31.5:-0.5]
    set cbrange [-9:255]
    unset colorbox
    set palette defined (-9 "#ffffff", -5 "#ffffff", -4.9 "#10242e", -0.5 "#10242e", 0 "#f6efe0", 90 "#f3d9a4", 180 "#e8863a", 255 "#b3201f")
    set multiplot layout 5,4 title "Paper No. 6, dark where it is torn, coloured by stress: as it tears, after 0.1, 0.4 and 1 s\nFour specimens all wet; the last one wet in its left half" margins 0.02,0.98,0.01,0.93 spacing 0.01,0.01
    do for [specimen = 1:5] { do for [moment = 0:3] {
        plot dir.sprintf("/hole-%d-%d.txt", specimen, moment) matrix with image
    } }
    unset multiplot
}
