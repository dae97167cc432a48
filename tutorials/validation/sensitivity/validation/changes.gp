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
stats 'changes.dat' using 0 nooutput
do for [k = 0:STATS_blocks - 1] {
    scene = system(sprintf("awk -v k=%d 'BEGIN { RS = \"\\n\\n\\n\"; FS = \"\\\"\" } NR == k + 1 { print $2 }' changes.dat", k))
    count = system(sprintf("awk -v k=%d 'BEGIN { RS = \"\\n\\n\\n\"; FS = \"\\n\" } NR == k + 1 { n = split($2, c, \" \"); print n }' changes.dat", k))
    if (strlen(count) == 0) { continue }
    columns = int(count)
    set title scene
    plot for [c = 2:columns] 'changes.dat' index k \
            using c:xtic(1) title columnheader(c), \
        1 lc 'black' dt 2 title 'band'
}
unset multiplot
