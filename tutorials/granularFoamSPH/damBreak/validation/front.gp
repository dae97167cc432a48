# Fronts against time, with the phases of the experiment
set terminal pngcairo size 900,560 font ",11" noenhanced
set output "front.png"
set xlabel "t/tc"
set ylabel "(l - l0)/l0 over its last value"
set key bottom right
set yrange [0:1.1]
set xrange [0:6]
set arrow from 0.8, graph 0 to 0.8, graph 1 nohead dt 3
set arrow from 2.8, graph 0 to 2.8, graph 1 nohead dt 3
set arrow from 3.4, graph 0 to 3.4, graph 1 nohead dt 3
set label "accelerating" at 0.05, 1.05
set label "steady" at 1.6, 1.05
set label "slowing" at 2.83, 1.05
# Trapezoid of speed with 0.8, 2 and 0.6 tc
f(t) = t < 0.8 ? t*t/1.6/2.7 : t < 2.8 ? (t - 0.4)/2.7 : \
    t < 3.4 ? (2.4 + (t - 2.8)*(1 - (t - 2.8)/1.2))/2.7 : 1
last(file) = system("tail -n 1 ".file." | awk '{ print $2 }'") + 0
plot f(x) w l lw 2 lc "black" t "phases of Lajeunesse et al. 2005", \
    for [file in files] file u 1:($2/last(file)) w l lw 1.6 \
        t file[7:strlen(file) - 4]
