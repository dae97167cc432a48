# The columns of a run against the grains, as rows of results.tsv:
#
#     awk -v a=0.5 -v H0=0.149 -v n=20 -f curves.awk -f compare.awk \
#         a0.5_profiles.csv a0.5_basilisk.csv profile_<time>.dat ...
#     awk -v a=6.26 -v H0=0.677 -v n=10 -f curves.awk -f compare.awk \
#         a6.26_profiles.csv a6.26_history.csv a6.26_envelope.csv \
#         profile_<time>.dat ...
#
# curves.awk stands in etc. Thickness is compared at x = (k + 1/2) 1.5 d, the bins
# of the grain data, by linear interpolation, wherever one of the two is not zero.
# The heap of grains is the mean of its left and its right half; its scatter is the
# difference of one half from this mean. Fronts: the farthest x where the thickness
# is 1.5 d and 3 d, and the x within which 98 % of the area lies.

BEGIN {
    FS = "[, \t]+"
    d = 0.005/H0                    # lengths in H0
    L0 = 1/a
    tc = sqrt(H0/9.81)
    width = 1.5*d
    bins = int(40*L0/width)
    zero = 1e-9
}

function apart(one, other)
{
    return difference(one, other, width, bins, zero)
}

# The x within which this part of the area lies
function quantile(curve, part,    k, fine, sum, target)
{
    fine = width/4
    for (k = 0; k < 4*bins; k++) sum += at(curve, (k + 0.5)*fine)
    target = part*sum
    sum = 0
    for (k = 0; sum < target; k++) sum += at(curve, (k + 0.5)*fine)
    return (k - (sum - target)/at(curve, (k - 0.5)*fine))*fine
}

# Mean thickness to x = 2 d
function centre(curve,    k, sum)
{
    for (k = 0; k < 20; k++) sum += at(curve, (k + 0.5)*d/10)
    return sum/20
}

FNR == 1 {
    file = FILENAME
    sub(/.*\//, "", file)
    time = file
    gsub(/profile_|\.dat$/, "", time)
    t = sprintf("%.2f", time/tc) + 0
}

/^ *#/ || /^[a-z]/ { next }

# block, t/tc, x/d, h/d, x/H0, h/H0
file ~ /_profiles/ { add("all" ($2 + 0), $5, $6); next }

# t/tc, x/H0, h/H0
file ~ /_basilisk/ { add("basilisk" ($1 + 0), $2, $3); next }

# t/tc, x98/L0, ...
file ~ /_history/ { x98[$1 + 0] = $2*L0; next }

# t/tc, x/L0, height of the tops/L0, ..., area of grains over that below them
file ~ /_envelope/ {
    tops = $1 + 0
    if (tops == 0) { fill += $5; fills++ }
    add("dated" tops, $2*L0, $3*L0*$5)
    next
}

# x, h [m]
{ sub(/^ +/, "") }
$1 > 0 { add("run" t, $1/H0, $2/H0) }

function row(quantity, measured, reference, error, band, verdict, from)
{
    printf "Lagree, a = %s, n = %s\t%s\t%.4f\t%s\t%s\t%s\t%s\t%s\n", a, n, \
        quantity, measured, reference, error, band, verdict, from
}

function atMost(quantity, measured, limit, from)
{
    row(quantity, measured, "at most " limit, "-", "-", \
        limit == "" ? "-" : measured <= limit ? "pass" : "FAIL", from)
}

function within(quantity, measured, reference, band, from,    error)
{
    error = 100*(measured/reference - 1)
    row(quantity, measured, sprintf("%.4f", reference), \
        sprintf("%.2f", error), band, \
        band == "-" ? "-" : (error^2 <= band^2 ? "pass" : "FAIL"), from)
}

END {
    for (t = 1; t <= 6; t++)
    {
        for (k = 0; k < bins; k++)
        {
            x = (k + 0.5)*width
            left = at("all" t, -x)
            add("left" t, x, left)
            add("grains" t, x, 0.5*(left + at("all" t, x)))
        }
    }
    times = a == 0.5 ? "2 3 4 6" : "1 2 3 4 6"
    m = split(times, list, " ")
    for (i = 1; i <= m; i++)
    {
        t = list[i]
        goal = a == 0.5 ? (t < 6 ? 0.025 : 0.016) : (t < 6 ? "" : 0.006)
        from = sprintf("grains (scatter %.4f)", \
            apart("left" t, "grains" t))
        measured = apart("run" t, "grains" t)
        quantity = "RMS of the surface at " t " tc [H0]"
        if (goal == "")
            row(quantity, measured, "-", "-", "-", "-", from)
        else
            atMost(quantity, measured, goal, from)
        if (a == 0.5 && t < 6)
        {
            row("RMS from Basilisk at " t " tc [H0]", \
                apart("run" t, "basilisk" t), "-", "-", "-", "-", \
                "continuum mu(I) by others")
            row("RMS of Basilisk at " t " tc [H0]", \
                apart("basilisk" t, "grains" t), "-", "-", "-", "-", from)
        }
    }
    t = list[m]
    within("front, 1.5 d thick, at 6 tc [H0]", front("run" t, 1.5*d), \
        front("grains" t, 1.5*d), a == 0.5 ? 2 : "-", "grains")
    within("front, 3 d thick, at 6 tc [H0]", front("run" t, 3*d), \
        front("grains" t, 3*d), a == 0.5 ? "-" : 1.5, "grains")
    within("height at the centre, 6 tc [H0]", centre("run" t), \
        centre("grains" t), "-", "grains")
    if (a != 0.5)
    {
        # Tops times area, as a thickness of the packing at the start
        fill /= fills
        for (i = 1; i <= size["dated0.66"]; i++) H["dated0.66", i] /= fill
        atMost("RMS of the surface at 0.66 tc [H0]", \
            apart("run0.66", "dated0.66"), 0.025, "dated grains")
        m = split("0.66 0.95 1.24 1.52 2.28", list, " ")
        for (i = 1; i <= m; i++)
        {
            t = list[i] + 0
            within("x of 98 % of the area at " t " tc [H0]", \
                quantile("run" t, 0.98), x98[t], 3, "dated grains")
        }
    }
}
