# The table of ablation.csv: a column a tutorial, a row a term. A cell holds what
# decides its verdict, what speaks against it, and what switching the term off (or
# on) does to the time.
set terminal pngcairo size 1760,1130 font ",10" noenhanced
set output "ablation.png"
set datafile separator ","

verdicts = "needed,trades,buys speed,buys nothing,harms,would harm,would trade,would buy speed,would buy nothing,would help"
colours = "0x9ecae1 0xbcbddc 0xa1d99b 0xf4f4f4 0xfdae6b 0xcfcfcf 0xdadaeb 0xd5ecd0 0xf4f4f4 0xfee391"

# Column, row, colour, change for the worse, for the better, of the time, names
cells = "< awk -F, -v verdicts='".verdicts."' -v colours='".colours."' '" \
    ."BEGIN { OFS = \",\"; n = split(verdicts, v); split(colours, c, \" \"); " \
    ."for (k = 1; k <= n; ++k) colour[v[k]] = c[k] } " \
    ."FNR == NR { if (match($0, /label (off|on) /)) " \
    ."row[substr($0, RSTART + 6)] = ++rows; next } " \
    ."FNR == 1 { next } " \
    ."{ if (!($1 in column)) column[$1] = ++columns; d[2] = \" \"; " \
    ."split($7 == \"\" ? \"-\" : $7, d, \"; \"); " \
    ."print column[$1], row[$3 \" \" $2], colour[$4], d[1], d[2] == \"\" ? \" \" : d[2], " \
    ."$5 == \"-\" ? \" \" : \"time \" ($5 > 0 ? \"+\" : \"\") $5 \" %\", " \
    ."seen[$1]++ ? \" \" : $1, " \
    ."seen[$3 $2]++ ? \" \" : ($3 == \"on\" ? \"+ \" : \"\") $2 }' terms ablation.csv"

columns = int(system("awk -F, 'FNR > 1 && !s[$1]++ { n++ } END { print n }' ablation.csv"))
rows = int(system("grep -c ' label ' terms"))
left = -0.85 - 0.05*columns
width = columns + 0.5 - left
set xrange [left:columns + 0.5]
set yrange [rows + 0.5:-0.8]
unset xtics
unset ytics
unset border
unset key
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set style fill solid 1 noborder

# The key
do for [k = 1:10] {
    name = system(sprintf("echo '%s' | cut -d, -f %d", verdicts, k))
    x = left + width*(0.01 + 0.099*(k - 1))
    set object k rectangle from x, -0.7 to x + 0.015*width, -0.42 \
        fc rgb int(word(colours, k)) fs solid border lc 'gray60'
    set label k name at x + 0.019*width, -0.56 font ',9'
}
set label 11 "without ...  (+: with)" at 0.45, 0 right
plot cells u 1:2:(0.48):(0.46):3 w boxxyerror lc rgb variable, \
    cells u 1:($2 - 0.27):4 w labels font ',9', \
    cells u 1:2:5 w labels font ',9', \
    cells u 1:($2 + 0.27):6 w labels font ',8' tc rgb 'gray30', \
    cells u 1:(0):7 w labels, \
    cells u (0.45):2:8 w labels right
