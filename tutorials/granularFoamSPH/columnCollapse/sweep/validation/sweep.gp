# Run-out and height of the sweep against the laws of sand and glass beads
set terminal pngcairo size 1200,560 font ",11" noenhanced
set output "sweep.png"
set datafile separator ","
set datafile commentschars "#"
set logscale xy
set xrange [0.2:20]
set xlabel "a = h0/r0"
set key left top Left reverse
# Of what has come to its end; nothing in the short mode
written = "< cat sweep_asWritten_*.dat 2>/dev/null | tr ' ' ',' | grep . || echo NaN,NaN,NaN"
set multiplot layout 1,2
lube(a) = a < 1.8 ? 1.2*a : a > 2.8 ? 1.9*a**(2.0/3) : 1/0
glass(a) = a < 3 ? 1.8*a : 2.5*a**(2.0/3)
set ylabel "run-out (r - r0)/r0"
set yrange [0.2:30]
plot lube(x) w l lw 2 lc "black" t "sand, Lube et al. 2005", \
    glass(x) w l dt 2 lc "gray50" t "glass beads, Lajeunesse et al. 2005", \
    "validation/lajeunesse2005Runout.csv" u 1:2 w p pt 6 lc "gray50" \
        t "their experiments", \
    "< tr ' ' ',' < sweep_I0_0.279.dat" u 1:2 w lp pt 7 lc 1 t "I0 = 0.279", \
    "< tr ' ' ',' < sweep_I0_2.65.dat" u 1:2 w lp pt 5 lc 2 t "I0 = 2.65", \
    written u 1:2 w p pt 9 lc 4 t "as written, implicit"
lubeHeight(a) = a < 1.15 ? a : a**0.4
glassHeight(a) = a < 0.7 ? a : 0.9*a**(1.0/3)
set ylabel "height h/r0"
set yrange [0.15:5]
plot lubeHeight(x) w l lw 2 lc "black" t "sand, Lube et al. 2005", \
    glassHeight(x) w l dt 2 lc "gray50" \
        t "glass beads, Lajeunesse et al. 2005", \
    "validation/lajeunesse2005Height.csv" u 1:2 w p pt 6 lc "gray50" \
        t "their experiments", \
    "< tr ' ' ',' < sweep_I0_0.279.dat" u 1:3 w lp pt 7 lc 1 t "I0 = 0.279", \
    "< tr ' ' ',' < sweep_I0_2.65.dat" u 1:3 w lp pt 5 lc 2 t "I0 = 2.65", \
    written u 1:3 w p pt 9 lc 4 t "as written, implicit"
