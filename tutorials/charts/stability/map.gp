# The map: a row a hazard, a column a scheme, coloured by the verdict, with the
# quantity that decides
set terminal pngcairo size 1500,950 font ",9" noenhanced
set output "map.png"
list(column) = system("awk -F, 'NR > 1 && !seen[$".column."]++ { print $" \
    .column." }' map.csv")
hazards = list(1)
schemes = list(2)
place(name, all) = sum [k=1:words(all)] (word(all, k) eq name ? k : 0)
title_(hazard) = system("sed -n 's/^title=\"\\(.*\\)\"/\\1/p' hazards/".hazard)
colour(verdict, outcome) = \
    verdict eq "survives" ? 0x9fd69f : verdict eq "degrades" ? 0xf7e08a : \
    verdict eq "refused" ? 0xc9d6ea : verdict ne "fails" ? 0xeeeeee : \
    outcome[1:5] eq "stops" ? 0xb9a0d8 : outcome[1:5] eq "warns" ? 0xf2b27c : \
    0xe8827c
text(verdict, quantity, value, outcome) = \
    verdict eq "fails" && outcome[1:5] eq "stops" ? \
        sprintf("stops at %.3g s", real(value)) : \
    quantity eq "-" ? verdict eq "refused" ? "refused" : "" : \
    quantity." ".value
set datafile separator ","
set xrange [0.5:words(schemes) + 0.5]
set yrange [words(hazards) + 0.5:0.5]
unset key
unset tics
set lmargin 27
set rmargin 1
set tmargin 3
set bmargin 3
do for [k=1:words(schemes)] {
    set label word(schemes, k) at k, graph 1.02 center font ",10" }
do for [k=1:words(hazards)] {
    set label title_(word(hazards, k)) at graph -0.005, first k right font ",10" }
set label "green: survives   yellow: degrades   red: fails and does not say so".\
    "   orange: fails, the log warns   violet: stops with a message".\
    "   blue: refused   grey: no such choice" \
    at graph 0.5, graph -0.03 center font ",10"
set style fill solid border lc "white"
plot "< tail -n +2 map.csv" u (place(strcol(2), schemes)): \
        (place(strcol(1), hazards)):(0.5):(0.5): \
        (colour(strcol(3), strcol(8))) w boxxyerror lc rgb variable, \
    "" u (place(strcol(2), schemes)):(place(strcol(1), hazards)): \
        (text(strcol(3), strcol(4), strcol(5), strcol(8))) w labels font ",8.5"
