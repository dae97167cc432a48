# Surfaces of the finest columns beside those of the grains
set terminal pngcairo size 900,420
set output 'surfaces.png'
set multiplot layout 1,2
set key top right
set xlabel 'x/H_0'
set ylabel 'h/H_0'
files(a, n) = system(sprintf("ls runs/a%s_n%d_s1/postProcessing/postRunout/0/profile_*.dat 2>/dev/null | sort -t_ -k3 -g", a, n))
do for [k = 1:2] {
    a = k == 1 ? '0.5' : '6.26'
    H0 = k == 1 ? 0.149 : 0.677
    n = k == 1 ? 80 : 40
    set title 'a = '.a.', n = '.n
    set xrange [0:(k == 1 ? 5 : 3)]
    plot for [t = 1:6] '< grep "^[0-9]" validation/a'.a.'_profiles.csv | tr , " "' \
            using (column(2) == t && column(5) >= 0 ? column(5) : NaN):6 \
            with points pt 7 ps 0.3 lc t title 'grains, t/t_c = '.t, \
        for [file in files(a, n)] file using ($1/H0):($2/H0) with lines \
            lc 'gray30' notitle
}
unset multiplot
