# Which layers flow and which stop, beside the experimental fit of Eq. 50
set terminal pngcairo size 640,480 font "sans,10"
set output "stopping.png"
set xlabel "slope [deg]"
set ylabel "thickness in grains, h/d"
set xrange [18.5:26]
set yrange [0:45]
set key outside top center horizontal
set samples 500
set arrow 1 from 20.9,0 to 20.9,45 nohead dt 2
set label 1 "{/Symbol m}_s" at 20.5,43
t(x) = tan(x*pi/180)
hstop(x) = x > 20.95 ? 1.65*(t(32.76) - t(x))/(t(x) - t(20.9)) : NaN
plot hstop(x) lw 2 lc rgb "black" title "h_{stop}, fit to experiment", \
     '< grep "^glass" validation/hstop.csv | tr "," " "' using 3:4 \
        with points pt 2 lc rgb "black" notitle, \
     "measured.dat" using ($5 == 1 ? $1 : NaN):2 \
        with points pt 6 ps 1.5 lc rgb "blue" title "solver: flows", \
     "measured.dat" using ($5 == 0 ? $1 : NaN):2 \
        with points pt 7 ps 1.5 lc rgb "red" title "solver: stops"
