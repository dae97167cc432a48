# How far starts, spacing and constants move the numbers, in their bands
set terminal pngcairo size 1300,800
set output 'changes.png'
set multiplot layout 2,2
set style data histograms
set style histogram clustered gap 2
set style fill solid 0.8 border -1
set xtics rotate by -35 font ',9'
set ylabel 'largest change / band'
set key outside right top font ',9'
set yrange [0:*]
set datafile missing '-'

# A block a scene, its name and quantities in the first line
block(k, what) = system(sprintf("awk -F'\"' '/^\"/ && n++ == %d { print %s }' changes.dat", k, what))
do for [k = 0:int(system("grep -c '^\"' changes.dat")) - 1] {
    scene = block(k, '$2')
    columns = int(block(k, '(NF - 1)/2'))
    set title scene
    plot for [c = 2:columns] 'changes.dat' index k \
            using c:xtic(1) title columnheader(c), \
        1 lc 'black' dt 2 title 'band'
}
unset multiplot
