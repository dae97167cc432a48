# Reads particles (.vtp, ASCII) and has what all scenes measure with them:
#
#     value[f, name, k]   component k of an array of file f, counted from 1
#     number[f]           of particles; particle i has x(f, i), y(f, i)
#
# A scene's own file adds the rest and prints rows 'quantity, error %, band %'
# (-: no band), tab-separated.
function x(f, i) { return value[f, "Points", 3*i] }
function y(f, i) { return value[f, "Points", 3*i + 1] }
function Ux(f, i) { return value[f, "U", 3*i] }
function Uy(f, i) { return value[f, "U", 3*i + 1] }
function p(f, i) { return value[f, "p", i] }
function m(f, i) { return value[f, "m", i] }
function sxy(f, i) { return value[f, "s", 6*i + 3] }
function row(quantity, error, band)
{
    printf "%s\t%.4g\t%s\n", quantity, error, band
}
function abs(a) { return a < 0 ? -a : a }
function tan(a) { return sin(a)/cos(a) }

# Pressure at a place: of the plane through the pressures within 2 dx, by least
# squares. Sets neighbours, without the particle self, and nearest [dx].
function plane(f, X, Y, self,    a, b, j, k, list, c, u, v, r, q, M, det)
{
    split("", M)
    neighbours = 0
    nearest = 9
    for (a = -1; a <= 1; ++a) for (b = -1; b <= 1; ++b)
    {
        c = split(cell[f, cellOf(X) + a, cellOf(Y) + b], list, " ")
        for (k = 1; k <= c; ++k)
        {
            j = list[k]
            u = (x(f, j) - X)/dx
            v = (y(f, j) - Y)/dx
            r = u*u + v*v
            if (r > 4) continue
            q = p(f, j)
            M[1] += 1; M[2] += u; M[3] += v
            M[4] += u*u; M[5] += u*v; M[6] += v*v
            M[7] += q; M[8] += q*u; M[9] += q*v
            if (j != self)
            {
                ++neighbours
                if (r < nearest*nearest) nearest = sqrt(r)
            }
        }
    }
    det = M[1]*(M[4]*M[6] - M[5]^2) - M[2]*(M[2]*M[6] - M[5]*M[3]) \
        + M[3]*(M[2]*M[5] - M[4]*M[3])
    if (neighbours < 6 || det < 1e-6) return ""
    return (M[7]*(M[4]*M[6] - M[5]^2) - M[2]*(M[8]*M[6] - M[5]*M[9]) \
        + M[3]*(M[8]*M[5] - M[4]*M[9]))/det
}
function cellOf(X) { return int(X/(2*dx) + 1000) }
function sort(f,    i)
{
    for (i = 0; i < number[f]; ++i)
        cell[f, cellOf(x(f, i)), cellOf(y(f, i))] = \
            cell[f, cellOf(x(f, i)), cellOf(y(f, i))] " " i
}
# RMS of pressures about the planes of their neighbourhoods [Pa]
function roughness(f,    i, q, sum, n)
{
    sort(f)
    for (i = 0; i < number[f]; ++i)
        if ((q = plane(f, x(f, i), y(f, i), i)) != "")
        {
            sum += (p(f, i) - q)^2
            ++n
        }
    return sqrt(sum/n)
}
function speed(f,    i, sum)
{
    for (i = 0; i < number[f]; ++i) sum += Ux(f, i)^2 + Uy(f, i)^2
    return sqrt(sum/number[f])
}

BEGIN { pi = atan2(0, -1) }
FNR == 1 { ++file; array = "" }
/<DataArray/ {
    array = $0
    sub(/.*Name="/, "", array)
    sub(/".*/, "", array)
    if (array !~ /^(U|p|m|s|Points)$/) array = ""
    count = 0
    next
}
/<\/DataArray/ {
    if (array == "m") number[file] = count
    array = ""
    next
}
/</ { next }
array != "" { for (i = 1; i <= NF; ++i) value[file, array, count++] = $i }
