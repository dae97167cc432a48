# What the paper says in words about Figs 10 to 12, measured, as rows of
# results.tsv. The first file is energies.dat, the others are surfaces:
#     awk -v a=0.9 -v r0=0.0972 -f figures.awk energies.dat profile_<time>.dat ...
FNR == 1 {
    ++files
    time = FILENAME
    gsub(/.*profile_|\.dat$/, "", time)
    if (files > 1 && time + 0 > last) last = time + 0
}

/^ *#/ { next }

files == 1 {
    for (t = 0.1; t < 0.115; t += 0.01)
    {
        if ($1 <= t + 1e-9) kinetic[sprintf("%.2f", t)] = $2
    }
    next
}

$1 > 0 {
    n = ++size[time + 0]
    x[time + 0, n] = $1/r0
    h[time + 0, n] = $2/r0
}

function row(figure, quantity, measured, reference, verdict)
{
    printf "%s, a = %s, I0 = %s\t%s\t%.3f\t%s\t-\t-\t%s\tthe paper in words\n", \
        figure, a, I0, quantity, measured, reference, verdict
}

# The farthest x of the surface at time t that is at least so high
function reach(t, height,    i)
{
    for (i = size[t]; i > 1 && h[t, i] < height; i--);
    return x[t, i]
}

# The written time nearest to t
function nearest(t,    time, best)
{
    best = last
    for (time in size) if ((time - t)^2 < (best - t)^2) best = time + 0
    return best
}

END {
    tc = sqrt(a*r0/9.81)
    if (a == 0.9)
    {
        ratio = kinetic["0.11"]/kinetic["0.10"]
        row("Fig. 10", "kinetic energy at 0.11 s over that at 0.1 s", ratio, \
            "less than 1: slowing", ratio < 1 ? "pass" : "FAIL")
    }
    if (a == 2.75)
    {
        # Least squares of the surface between 10 and 90 % of its height
        n = size[last]
        for (i = 1; i <= n; i++) top = h[last, i] > top ? h[last, i] : top
        for (i = 1; i <= n; i++)
        {
            if (h[last, i] < 0.1*top || h[last, i] > 0.9*top) continue
            ++m
            sx += x[last, i]; sy += h[last, i]
            sxx += x[last, i]^2; sxy += x[last, i]*h[last, i]
            syy += h[last, i]^2
        }
        slope = (m*sxy - sx*sy)/(m*sxx - sx^2)
        rms = sqrt((syy - sy^2/m - slope*(sxy - sx*sy/m))/m)
        row("Fig. 11", "deposit off a straight slope, RMS over height", \
            rms/top, "a cone", "-")
    }
    if (a == 4.8)
    {
        for (k = 0.25; k <= 1; k += 0.75)
        {
            t = nearest((k == 1 ? 0.1 : 0.03))
            top = 0
            for (i = 1; i <= size[t]; i++) top = h[t, i] > top ? h[t, i] : top
            row("Fig. 12", sprintf("half-width of the flat top at %.3f s [r0]", \
                t), reach(t, 0.95*top), "1: keeps its shape", "-")
        }
    }
}
