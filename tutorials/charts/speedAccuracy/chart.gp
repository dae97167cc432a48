# Error against processor time of a scene's runs, the front drawn and numbered, its
# runs listed beside it: scene and name are given
set terminal pngcairo size 1280,720 font ",11" noenhanced
set output scene.".png"
set datafile separator ","
set logscale xy
set ytics (0.001, 0.002, 0.003, 0.005, 0.007, 0.01, 0.015, 0.02, 0.03, 0.05, 0.07, \
    0.1, 0.2, 0.5, 1)
set xlabel "processor time [s]"
set ylabel "error"
set title name
set rmargin at screen 0.72
set key at screen 0.99, 0.98 right top reverse Left samplen 2
set grid
runs(condition) = "< awk -F, -v OFS=, '$1 == \"".scene."\" && $6 ~ /^[0-9]/ && $6 > 0 && ".condition."' runs.csv | sort -t, -k5g"
front = "< grep '^".scene.",' fronts.csv | awk -v OFS=, '{ print $0, NR }'"
peers = "< grep '^".scene.",' validation/peers.csv"
number(file) = int(system(file[3:]." | grep -c ."))
named(setting) = runs("$3 == \"".setting."\"")

# From below the best run to above the worst one as in the tutorials; what is worse
# is counted
greatest(condition) = real(system(runs(condition)[3:]." | awk -F, '{ e = $6 > e ? $6 : e } END { print e + 0 }'"))
least = real(system(runs("1")[3:]." | awk -F, '{ e = !e || $6 < e ? $6 : e } END { print e + 0 }'"))
top = 2.5*greatest("$3 == \"base\"")
if (top == 0) top = 2.5*greatest("1")
set yrange [0.8*least:top]
worse = number(runs(sprintf("$6 > %g", top)))
if (worse) set label 1 sprintf("%d runs with greater errors are not shown", worse) \
    at graph 0.99, 0.97 right

# The runs of the front, in the margin
do for [k = 1:number(front)] {
    set label 10 + k system(sprintf("grep '^%s,' fronts.csv | awk -F, 'NR == %d { printf \"%%2d  %%s, %%s\", NR, $4, $5 }'", scene, k)) \
        at screen 0.735, 0.66 - 0.028*k font ",10" tc lt 7
}
set label 10 "front: particles across, settings" at screen 0.735, 0.66 font ",10"

command = "plot "
single = runs("$3 !~ /^(base|fast|balanced|accurate)$/ && $3 !~ /[+]/")
several = runs("$3 ~ /[+]/")
if (number(single)) command = command \
    ."single u 5:6 w p pt 7 ps 0.7 lc 'gray60' t 'one choice changed', "
if (number(several)) command = command \
    ."several u 5:6 w p pt 7 ps 0.7 lc 'skyblue' t 'several', "
if (number(peers)) command = command \
    ."peers u 2:3 w p pt 9 ps 2 lc 4 t 'others', " \
    ."peers u 2:3:4 w labels left offset 1,-0.6 tc lt 4 notitle, "
if (number(named("base"))) command = command \
    ."named('base') u 5:6 w lp pt 5 ps 1.2 lc 'black' t 'as in the tutorials', "
if (number(named("fast"))) command = command \
    ."named('fast') u 5:6 w lp pt 4 lc 2 t 'fast', " \
    ."named('balanced') u 5:6 w lp pt 6 lc 6 t 'balanced', " \
    ."named('accurate') u 5:6 w lp pt 8 lc 1 t 'accurate', "
command = command \
    ."front u 2:3 w steps lw 2 lc 7 t 'front', " \
    ."front u 2:3:6 w labels offset 0,-0.8 font ',10' tc lt 7 notitle"
eval(command)
