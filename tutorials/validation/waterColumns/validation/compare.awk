# The front of a run against measured ones, as rows of results.tsv:
#
#     awk -v a=0.05715 -v n=20 -f compare.awk martinMoyce.csv \
#         koshizukaOka.csv front.dat frontOfHalf.dat
#
# Z = x/a against T = t sqrt(2 g/a), a the base. RMS difference at the measured
# T, over the range of the measured Z: as the data stand; then with the shift of
# their T, the same for all points, that makes it least, and with fronts of half
# the thickness, both without a verdict. Speed of the front: slope of the
# regression over T > 4, in units of Ritter's front, dZ/dT = 2, which no mean
# speed (Z - 1)/T may exceed.

BEGIN {
    FS = "[, \t]+"
    unit = sqrt(a/(2*9.81))
    name["martinMoyce"] = "Martin & Moyce"
    name["koshizukaOka"] = "Koshizuka & Oka"
}

FNR == 1 {
    file = FILENAME
    sub(/.*\//, "", file)
    sub(/\..*/, "", file)
}

/^ *#/ || /^[A-Z]/ { next }

file in name { add(file, $1, $2); next }

# Time, t/tc, frontLeft, frontRight [m]
{ sub(/^ +/, ""); add(file, $1/unit, $4/a) }

function add(curve, t, z)
{
    ++size[curve]
    T[curve, size[curve]] = t
    Z[curve, size[curve]] = z
}

# Linear; the base before the start
function at(curve, t,    n, i, w)
{
    n = size[curve]
    if (t <= T[curve, 1]) return 1
    if (t >= T[curve, n]) return Z[curve, n]
    for (i = 2; T[curve, i] < t; i++);
    w = (t - T[curve, i - 1])/(T[curve, i] - T[curve, i - 1])
    return (1 - w)*Z[curve, i - 1] + w*Z[curve, i]
}

# RMS of the difference over the range of the data
function difference(curve, data, shift,    n, i, sum)
{
    n = size[data]
    for (i = 1; i <= n; i++)
    {
        sum += (at(curve, T[data, i] + shift) - Z[data, i])^2
    }
    return sqrt(sum/n)/(Z[data, n] - Z[data, 1])
}

function bestShift(curve, data,    k, best)
{
    for (k = -150; k <= 150; k++)
    {
        if (difference(curve, data, k/100) < difference(curve, data, best))
        {
            best = k/100
        }
    }
    return best + 0
}

# dZ/dT over T > 4, at the T of the data, for the data too
function speed(curve, data,    n, i, x, y, sx, sy, sxx, sxy)
{
    for (i = 1; i <= size[data]; i++)
    {
        if (T[data, i] <= 4) continue
        x = T[data, i]
        y = curve == data ? Z[data, i] : at(curve, x)
        n++
        sx += x; sy += y; sxx += x*x; sxy += x*y
    }
    return (n*sxy - sx*sy)/(n*sxx - sx*sx)
}

function fastest(curve,    i, v, most)
{
    for (i = 1; i <= size[curve]; i++)
    {
        if (T[curve, i] < 1) continue
        v = (Z[curve, i] - 1)/T[curve, i]
        if (v > most) most = v
    }
    return most
}

function row(data, quantity, measured, reference, error, band, verdict, from)
{
    printf "Water, %s, n = %s\t%s\t%.4f\t%s\t%s\t%s\t%s\t%s\n", data, n, \
        quantity, measured, reference, error, band, verdict, from
}

function compare(data,    e, s)
{
    e = difference("front", data, 0)
    row(name[data], "RMS of the front, of its range", e, "at most 0.05", \
        "-", "-", e <= 0.05 ? "pass" : "FAIL", "T as published")
    row(name[data], "the same, front of half the thickness", \
        difference("frontOfHalf", data, 0), "-", "-", "-", "-", \
        "information")
    s = bestShift("front", data)
    row(name[data], "the same, best shift of T", \
        difference("front", data, s), "-", "-", "-", "-", \
        sprintf("information: T + (%.2f)", s))
}

END {
    compare("martinMoyce")
    compare("koshizukaOka")
    v = speed("front", "martinMoyce")
    ref = speed("martinMoyce", "martinMoyce")
    e = 100*(v/ref - 1)
    row("Martin & Moyce", "speed of the front, dZ/dT over T > 4", v, \
        sprintf("%.4f", ref), sprintf("%.2f", e), 5, \
        e^2 <= 25 ? "pass" : "FAIL", "regression; no time zero in it")
    v = fastest("front")
    row("Ritter", "largest (Z - 1)/T", v, "at most 2", "-", "-", \
        v <= 2 ? "pass" : "FAIL", "Ritter 1892, a bound")
}
