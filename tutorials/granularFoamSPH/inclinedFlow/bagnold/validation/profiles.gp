# Velocity profiles beside Eq. 40 and the start-up solution, from the case
set terminal pngcairo size 900,420 font "sans,10"
set output "profiles.png"
set multiplot layout 1,2
set key bottom right
set xlabel "U.x [m/s]"
set ylabel "y [mm]"

steady(theta) = system("ls -t runs/steady".theta \
    ."n40/postProcessing/steady/0/profile_*.dat | head -n 1")
starting(time) = system("ls runs/starting24n40/postProcessing/starting/0/" \
    ."profile_".time."*.dat | head -n 1")
exact(file, key) = '< grep "^'.key.'," validation/'.file.' | tr "," " "'

theta = "22 24 26"
set title "Steady flow of glass beads, 40 layers"
plot for [k=1:3] exact("bagnold.csv", word(theta, k)) using 3:(1e3*$2) \
        with lines lc rgb "black" title k == 1 ? "Eq. 40" : "", \
     for [k=1:3] steady(word(theta, k)) using 3:(1e3*$1) \
        with points pt 6 ps 0.7 lc k title word(theta, k)." deg"

# Written at the first step after these times
key = "0.1 0.2 0.4 0.8 1.6 3.2"
file = "0.1 0.2 0.3999 0.8 1.5999 3.2"
set title "From rest, 24 deg"
plot for [k=1:6] exact("startup.csv", word(key, k)) using 3:(1e3*$2) \
        with lines lc rgb "black" title k == 1 ? "1D solution" : "", \
     for [k=1:6] starting(word(file, k)) using 3:(1e3*$1) \
        with points pt 6 ps 0.7 lc k title word(key, k)." s"
unset multiplot
