# RMS difference of the free surface from that of the grains, in H0:
#
#     awk -f curves.awk -f surfaceError.awk grains.csv basilisk.csv \
#         profile_<time>.dat ...
#
# curves.awk stands in etc. Compared is the thickness at x = (k + 1/2) 1.5 d, the
# bins of the grain data, by linear interpolation, wherever one of the two is not
# zero. The grain heap is the mean of its left and its right half; its scatter is
# the difference of one half from this mean.

BEGIN {
    d = 0.005
    H0 = 0.149
    tc = sqrt(H0/9.81)
    binWidth = 1.5*d/H0
    bins = 100                                      # to x = 5 H0
    zero = 1e-9
}

function from(grains, curve)
{
    return size[curve] \
      ? sprintf("%.4f", difference(curve, grains, binWidth, bins, zero)) : "-"
}

FNR == 1 {
    file = FILENAME
    sub(/.*\//, "", file)
    time = file
    gsub(/profile_|\.dat$/, "", time)
    t = sprintf("%.2f", time/tc) + 0
}

/^ *#/ || /^[a-z]/ { next }

{ gsub(/,/, " ") }

# block, t/tc, x/d, h/d, x/H0, h/H0
file == "grains.csv" { add("all" $2, $5, $6); next }

# t/tc, x/H0, h/H0
file == "basilisk.csv" { add("basilisk" $1, $2, $3); next }

# x, h [m]
$1 > 0 { add("run" t, $1/H0, $2/H0) }

END {
    print "Free surface: RMS difference from that of the grains, in H0\n"
    printf "%5s%11s%11s%20s\n",
        "t/tc", "this run", "Basilisk", "scatter of grains"
    for (t = 2; t <= 4; t++)
    {
        for (k = 0; k < bins; k++)
        {
            x = (k + 0.5)*binWidth
            left = at("all" t, -x)
            add("left" t, x, left)
            add("grains" t, x, 0.5*(left + at("all" t, x)))
        }
        printf "%5d%11s%11s%20s\n", t,
            from("grains" t, "run" t),
            from("grains" t, "basilisk" t),
            from("grains" t, "left" t)
    }
}
