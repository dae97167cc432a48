# Errors against the spacing: the constants as they are, and the choices that
# change most
set terminal pngcairo size 1300,440
set output 'errors.png'
set datafile separator tab
set multiplot layout 1,2
set logscale xy
set xlabel 'particles over the layer'
set ylabel 'error [%]'
set xrange [8:100]
set yrange [0.02:300]
set xtics (10, 20, 40, 80)
set key outside right top samplen 1 font ',9'
of(scene, variant, quantity) = sprintf( \
    "< awk -F'\t' '$1 == \"%s\" && $2 == \"%s\" && index($4, \"%s\") == 1 && $5 != \"-\" { print $3 FS ($5 < 0 ? -$5 : $5) }' errors.tsv", \
    scene, variant, quantity)
set title 'as in columnCollapse/sandA0.9'
plot of('hydrostatic', '-', 'pressure') with linespoints title 'hydrostatic: p', \
    of('shear', '-', 'U') with linespoints title 'plane shear: U', \
    of('bagnold', '-', 'U') with linespoints title 'Bagnold: U', \
    of('bagnold', 'start', 'U at 0.8') with linespoints title 'Bagnold at 0.8 s: U', \
    of('chute', '-', 'U at 0.25') with linespoints title 'chute: U', \
    of('channel', '-', 'U') with linespoints title 'channel: U', \
    of('creep', '-', 'U') with linespoints title 'creep: U', \
    of('vortex', '-', 'rate') with linespoints title 'vortices: decay', \
    of('wave', '-', 'frequency') with linespoints title 'wave: frequency', \
    of('patch', '-', 'p at') with linespoints title 'patch: p', \
    20/x with lines dt 2 lc 'gray' title '20 %/n'
set title 'other choices'
plot of('shear', 'muI+Morris', 'U') with linespoints title 'plane shear: muI, Morris', \
    of('bagnold', 'volume', 'U') with linespoints title 'Bagnold: deltaSPHVolume', \
    of('channel', 'Morris', 'U') with linespoints title 'channel: Morris', \
    of('channel', 'elastic', 'U') with linespoints title 'channel: elastic law', \
    of('creep', 'Morris', 'U') with linespoints title 'creep: Morris', \
    of('vortex', 'jitter', 'rate') with linespoints title 'vortices: decay, jitter', \
    of('wave', 'mirror', 'frequency') with linespoints title 'wave: frequency, mirror', \
    of('wave', 'mirror+Wendland', 'frequency') with linespoints title 'the same, Wendland', \
    of('wave', 'mirror', 'rate') with linespoints title 'wave: decay, mirror', \
    of('chute', 'soft', 'U at 0.05') with linespoints title 'chute at 0.05 s: soft', \
    20/x with lines dt 2 lc 'gray' title '20 %/n'
unset multiplot
