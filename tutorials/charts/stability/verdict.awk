# The verdict on a run from the bands and its quantities: the worst of them, and
# the quantity that has it.
#     awk -f verdict.awk bands <quantities>
/^#/ { next }
FNR == NR { degrades[$1] = $2; fails[$1] = $3; next }
{
    size = $2 < 0 ? -$2 : $2
    rank = size > fails[$1] ? 2 : size > degrades[$1] ? 1 : 0
    share = size/fails[$1]
    if (!any++ || rank > worst || rank == worst && share > most)
    {
        worst = rank
        most = share
        name = $1
        value = $2
        band = degrades[$1] " to " fails[$1]
    }
}
END {
    split("survives degrades fails", verdict)
    if (any) print verdict[worst + 1], name, value, band
    else print "fails - - -"
}
