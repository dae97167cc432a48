# Run-out and height against a, with the measured points and their regression
set terminal pngcairo size 900,420
set output 'columns.png'
set multiplot layout 1,2
set logscale xy
set key top left
set xlabel 'a = H_0/L_0'
runout(a) = a < 3 ? 1.81*a : 2.67*a**(2.0/3)
height(a) = a < 0.7 ? a : 0.9*a**(1.0/3)
set xrange [0.15:25]
set ylabel '(L_f - L_0)/L_0'
plot '< grep "^[0-9]" validation/runout.csv | tr , " "' using 1:2 with points pt 6 lc 'gray40' \
        title 'measured', \
    runout(x) lc 'gray40' title 'regression', \
    'columns.dat' using 1:3 with points pt 7 lc 'red' title 'here'
set ylabel 'H_f/L_0'
plot '< grep "^[0-9]" validation/height.csv | tr , " "' using 1:2 with points pt 6 lc 'gray40' \
        title 'measured', \
    height(x) lc 'gray40' title 'regression', \
    'columns.dat' using 1:4 with points pt 7 lc 'red' title 'here'
unset multiplot
