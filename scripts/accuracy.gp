# Called by accuracy.sh: gnuplot -c accuracy.gp FOLDER PLOT
# FOLDER holds files of "us per robot-tick, error in %, substeps, 1 for the engine's default".
folder = ARG1
set terminal svg size 960,480 font "DejaVu Sans,Helvetica,Arial,sans-serif,13" background rgb "white" dynamic
set output ARG2
set encoding utf8

# colours of Okabe and Ito, distinguishable with colour blindness; every engine also has its own
# mark
set style line 1 lc rgb 0x009E73 lw 2 pt 7
set style line 2 lc rgb 0x0072B2 lw 2 pt 5
set style line 3 lc rgb 0xD55E00 lw 2 pt 9
set style line 4 lc rgb 0xCC79A7 lw 2 pt 13 dt (6,4)
set style line 5 lc rgb 0x333333 lw 2 pt 3

set logscale xy
set grid xtics ytics lc rgb 0xdddddd lt 1
set border 3
set tics nomirror out
set mxtics 1
set mytics 1
set xtics format "%g"
set xlabel "cost of the whole tick, µs per robot-tick"
set yrange [0.0002:60]
set ytics ("≤ 0.001" 0.001, "0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10)
set xrange [0.15:1500]
unset key

# plot elements of a file: a line, its points, rings around defaults, the numbers of substeps at
# (dx, dy) from the points, and a label at the first one
line(name, style) = sprintf("'%s/%s' using 1:2 with linespoints ls %d ps 0.8", folder, name, style)
ring(name, style) = sprintf("'%s/%s' using ($4 == 1 ? $1 : NaN):2 with points ls %d pt 6 ps 2.1", folder, name, style)
text(name, style, dx, dy) = sprintf("'%s/%s' using 1:2:3 with labels offset %g,%g textcolor ls %d font ',12'", \
  folder, name, dx, dy, style)
title_at(name, style, dx, dy, t) = sprintf("'%s/%s' using 1:2:('%s') every ::0::0 with labels left offset %g,%g textcolor ls %d", \
  folder, name, t, dx, dy, style)
all(name, style, dx, dy) = line(name, style) . ", " . ring(name, style) . ", " . text(name, style, dx, dy)

set multiplot layout 1,2 margins 0.095,0.985,0.135,0.86 spacing 0.115
set label 1 "numbers: substeps of a tick of 0.1 s;   ◯ the engine's default" at screen 0.5,0.965 center

set title "1,000 e-pucks press against a wall, 20 deep" offset 0,-0.5
set ylabel "overlap, 99th percentile, % of the radius" offset 2.2,0
eval "plot " . all("crowd_kinematics2d", 1, 0, -1.1) . ", " . title_at("crowd_kinematics2d", 1, -1, 1.3, "kinematics2d") \
  . ", " . all("crowd_dynamics2d", 2, -1.6, -0.3) . ", " . title_at("crowd_dynamics2d", 2, -4, 1.1, "dynamics2d") \
  . ", " . all("crowd_adaptive", 2, 4, -0.1) \
  . ", " . all("crowd_mixed", 3, 1.8, 0.3) . ", " . title_at("crowd_mixed", 3, -4, 1.1, "dynamics3d")

unset label 1
set title "free e-pucks follow an arc for 60 s"
set ylabel "greatest distance from the arc, % of the path" offset 1.5,0
set label 2 "kinematics2d, dynamics2d, pointmass3d:\nexact with any number of substeps" at 0.22,0.006 textcolor ls 5
eval "plot " . line("arc_kinematics2d", 1) . ", " . line("arc_dynamics2d", 2) . ", " . line("arc_adaptive", 2) \
  . ", " . line("arc_pointmass3d", 5) \
  . ", " . all("arc_mixed", 3, 0, -1.1) . ", " . title_at("arc_mixed", 3, -15, -4.5, "dynamics3d, mixed or direct") \
  . ", " . all("arc_iterative", 4, 0, 1.1) . ", " . title_at("arc_iterative", 4, -9, 2.4, "dynamics3d, iterative")
unset multiplot
