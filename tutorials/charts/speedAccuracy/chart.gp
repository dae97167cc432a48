# Error against processor time of a scene's runs, the front drawn and labelled:
# scene and name are given
set terminal pngcairo size 1100,700 font ",11" noenhanced
set output scene.".png"
set datafile separator ","
set logscale xy
set xlabel "processor time [s]"
set ylabel "error"
set title name
set key left bottom
set grid
runs(condition) = "< awk -F, -v OFS=, '$1 == \"".scene."\" && $6 ~ /^[0-9]/ && ".condition."' runs.csv"
front = "< grep '^".scene.",' fronts.csv"
peers = "< grep '^".scene.",' validation/peers.csv"
number(file) = int(system(file[3:]." | grep -c ."))
label(n, settings) = n.", ".settings

# What there is nothing of is not drawn
several = runs("$3 ~ /[+]/")
single = runs("$3 != \"base\" && $3 !~ /[+]/")
command = "plot "
if (number(single)) command = command \
    ."single u 5:6 w p pt 7 ps 0.7 lc 'gray60' t 'one choice changed', "
if (number(several)) command = command \
    ."several u 5:6 w p pt 7 ps 0.9 lc 3 t 'several', "
if (number(peers)) command = command \
    ."peers u 2:3 w p pt 9 ps 2 lc 4 t 'others', " \
    ."peers u 2:3:4 w labels left offset 1,0 tc lt 4 notitle, "
command = command \
    ."runs('$3 == \"base\"') u 5:6 w lp pt 5 ps 1.3 lc 'black' " \
    ."t 'as in the tutorials, coarse to fine', " \
    ."front u 2:3 w steps lw 2 lc 7 t 'front', " \
    ."front u 2:3:(label(stringcolumn(4), stringcolumn(5))) w labels left " \
    ."offset 0.5,0.6 font ',9' tc lt 7 notitle"
eval(command)
