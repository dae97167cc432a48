# The deposits of all routes that have come to their end, with the run-out and
# the height of the law; nr: the resolution that is drawn
set terminal pngcairo size 1100,560 font ",11" noenhanced
set output "routes.png"
r0 = 0.0972
set xlabel "x/r0"
set ylabel "h/r0"
set xrange [0:3.5]
set yrange [0:1.1]
set key right top
set title sprintf("Column of sand a = 0.9, nr = %d: last surface of each route", nr)
files = system(sprintf("ls surface_*_nr%d.dat", nr))
name(file) = system("echo ".file." | sed 's/surface_//; s/_nr.*//'")
set arrow from 2.08, graph 0 to 2.08, 0.15 nohead lw 2 lc "black"
set arrow from 0, 0.9 to 0.3, 0.9 nohead lw 2 lc "black"
set label "run-out and height, Lube et al. 2005" at 2.1, 0.13
plot for [file in files] file u ($1/r0):($2/r0) w l lw 2 t name(file)
