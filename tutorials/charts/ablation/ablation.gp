# The table of ablation.csv: a column a tutorial, a row a term; in a cell what
# decides its verdict and what switching the term off or on does to the time
set terminal pngcairo size 1660,1020 font ",10" noenhanced
set output "ablation.png"
set datafile separator ","

verdicts = "needed,buys speed,buys nothing,harms,would harm,would buy speed,would buy nothing,would help"
colours = "0x9ecae1 0xa1d99b 0xf2f2f2 0xfdae6b 0xd4d4d4 0xdcefd6 0xf2f2f2 0xfee391"
# Column, row, colour, what decides, change of the time
cells = "< awk -F, -v verdicts='".verdicts."' -v colours='".colours."' '" \
    ."BEGIN { OFS = \",\"; n = split(verdicts, v); split(colours, c, \" \"); " \
    ."for (k = 1; k <= n; ++k) colour[v[k]] = c[k] } " \
    ."FNR == NR { if (match($0, /label (off|on) /)) " \
    ."row[substr($0, RSTART + RLENGTH)] = ++rows; next } " \
    ."FNR == 1 { next } " \
    ."{ if (!($1 in column)) column[$1] = ++columns; " \
    ."print column[$1], row[$2], colour[$4], " \
    ."$7 == \"\" ? \"-\" : $7, ($5 > 0 ? \"+\" : \"\") $5 \" %\", " \
    ."$1, ($3 == \"on\" ? \"+ \" : \"\") $2 }' terms ablation.csv"

columns = int(system("awk -F, 'FNR > 1 && !s[$1]++ { n++ } END { print n }' ablation.csv"))
rows = int(system("grep -c ' label ' terms"))
set xrange [0.5:columns + 0.5]
set yrange [rows + 0.5:-0.7]
unset xtics
unset ytics
unset border
unset key
set lmargin 26
set rmargin 1
set tmargin 0
set bmargin 1
set style fill solid 1 noborder
set label "switched off; + on" at graph 0, first 0 right offset -1,0

# The key
do for [k = 1:8] {
    name = system(sprintf("echo '%s' | cut -d, -f %d", verdicts, k))
    x = 0.6 + (columns - 0.2)*(k - 1)/8.0
    set object k rectangle from x, -0.6 to x + 0.25, -0.35 fc rgb int(word(colours, k)) fs solid border lc 'gray60'
    set label k + 1 name at x + 0.32, -0.48
}
plot cells u 1:2:(0.48):(0.46):3 w boxxyerror lc rgb variable, \
    cells u 1:($2 - 0.17):4 w labels, \
    cells u 1:($2 + 0.2):5 w labels font ',8' tc rgb 'gray30', \
    cells u 1:(0):6 w labels font ',10', \
    cells u (0.45):2:7 w labels right
