# Fig. 2: viscosity over pressure and shear rate
set terminal pngcairo size 1300,430 font ",11" noenhanced
set output "viscosity.png"
set xlabel "log10 gammaDot [1/s]"
set ylabel "p [Pa]"
set cblabel "log10 eta [Pa s]"
set cbrange [-2:5]
set palette defined (0 "#440154", 1 "#365c8d", 2 "#1fa187", 3 "#a0da39")
set xrange [-3:3]
set yrange [0:3.3]
set ylabel "log10 p [Pa]"
set multiplot layout 1,3
do for [name in "Papanastasiou cap elastoViscoplastic"] {
    set title name
    plot "runs/".name."/postProcessing/rheologyMap/0/eta.dat" \
        using (log10($2)):(log10($1)):(log10($3)) with image notitle
}
