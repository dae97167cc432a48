# Front against time: measured, here, and Ritter's bound
set terminal pngcairo size 900,420
set output 'fronts.png'
set multiplot layout 1,2
set key bottom right
set xlabel 'T = t (2g/a)^{1/2}'
set ylabel 'Z = x/a'
a = 0.05715
unit = sqrt(a/(2*9.81))
front(n) = sprintf('runs/n%d/postProcessing/front/0/front.dat', n)
numbers = system("ls runs | sed 's/^n//' | sort -n")
do for [k = 1:2] {
    set xrange [0:(k == 1 ? 9.5 : 3.2)]
    set yrange [0:(k == 1 ? 17 : 4.5)]
    plot 1 + 2*x lc 'gray60' dt 2 title 'Ritter', \
        '< grep "^[0-9]" validation/martinMoyce.csv | tr , " "' \
            using 1:2 with points pt 6 lc 'black' title "Martin \\& Moyce", \
        '< grep "^[0-9]" validation/koshizukaOka.csv | tr , " "' \
            using 1:2 with points pt 4 lc 'black' title "Koshizuka \\& Oka", \
        for [n in numbers] front(int(n)) using ($1/unit):($4/a) with lines \
            title 'here, n = '.n
}
unset multiplot
