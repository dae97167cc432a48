# Quantities of a run, those that are asked for, one a line: name, value.
#     awk -v quantities=<names> -v H=... -f read.awk -f outside.awk -f measure.awk
#         <last particles> <first, or other, particles> [<table> ...]
# read.awk is that of validation/exact; outside(X, Y) is the hazard's.
#
# leaked      particles outside of the walls [%]
# net         catches of the last net of the walls, a hundred particles
# energy      greatest rise of kinetic + potential + elastic energy above what it
#             has been before, over M g H/2 and the kinetic energy at the start [%]
# volume      of the inner material, by counting, against that at rest [%]
# roughness   RMS of p about planes through the neighbours, over rho g H [%]
# speed, rest RMS at the end, over sqrt(g H) [%]
# moved       of front and height since a time, the larger one, over L0 [%]
# flow        L2 of the velocity against Eq. 40; or of the mean speed, what is
#             outside of its bounds [%]
# spin        change of the angular momentum [%]
# lonely      particles with less than four neighbours within 2 dx [%]
# runout, height   against the law of Lube et al. [%]
# difference  greatest distance from the particles of the other run [dx]

function asked(name) { return (" " quantities " ") ~ (" " name " ") }
function tell(name, value)
{
    if (asked(name)) printf "%s %.3g\n", name, value
}
function part(a) { return a - int(a) }

FILENAME ~ /energies/ && !/^ *#/ {
    total = $2 + $3 + $4
    if (!rows++) { mass = $6; kinetic0 = $2; least = total }
    if (total < least) least = total
    if (total - least > rise) rise = total - least
}
FILENAME ~ /runout/ && !/^ *#/ {
    if ($1 >= since && !seen++) { oldFront = $4; oldHeight = $6 }
    front = $4; runout = $5; height = $6
}

# Of the material where it surrounds a place, the mean over places that are spread
# evenly: the sum of Wendland's function of support 2 dx
function density(f,    at, key, k, X, Y, sum, n)
{
    for (at in cell)
    {
        split(at, key, SUBSEP)
        if (key[1] != f) continue
        for (k = 0; k < 4; ++k)
        {
            X = part(0.618034*key[2] + 0.381966*key[3] + 0.25*k)
            Y = part(0.754878*key[2] + 0.569840*key[3] + 0.5*k)
            X = 2*dx*(key[2] - 1000 + X)
            Y = 2*dx*(key[3] - 1000 + Y)
            if (surrounded(f, X, Y)) { sum += filling; ++n }
        }
    }
    return n > 9 ? sum/n : ""
}
# Sets filling. In the middle of what is near
function surrounded(f, X, Y,    a, b, c, k, list, j, u, v, q, w, U, V)
{
    filling = U = V = 0
    for (a = -1; a <= 1; ++a) for (b = -1; b <= 1; ++b)
    {
        c = split(cell[f, cellOf(X) + a, cellOf(Y) + b], list, " ")
        for (k = 1; k <= c; ++k)
        {
            j = list[k]
            u = (x(f, j) - X)/dx
            v = (y(f, j) - Y)/dx
            q = sqrt(u*u + v*v)
            if (q >= 2) continue
            w = (1 - q/2)^4*(2*q + 1)*7/(4*pi)
            filling += w; U += w*u; V += w*v
        }
    }
    return filling > 0 && sqrt(U*U + V*V) < 0.12*filling
}

END {
    N = number[1]
    sort(1)
    for (i = 0; i < N; ++i)
    {
        out += outside(x(1, i), y(1, i))
        q = plane(1, x(1, i), y(1, i), i)
        if (q != "") { rough += (p(1, i) - q)^2; ++inner }
        if (neighbours < 4) ++lonely
        mean += Ux(1, i)/N
    }
    tell("leaked", 100*out/N)
    tell("net", 100*hits/N)
    tell("lonely", 100*lonely/N)
    scale = mass*g*H/2 + kinetic0
    if (scale > 0) tell("energy", 100*rise/scale)
    if (asked("volume") && (q = density(1)) != "") tell("volume", 100*(1/q - 1))
    if (!p0) p0 = rho*g*H
    if (inner) tell("roughness", 100*sqrt(rough/inner)/p0)
    if (g > 0) { tell("speed", 100*speed(1)/sqrt(g*H))
        tell("rest", 100*speed(1)/sqrt(g*H)) }
    if (asked("moved"))
    {
        a = abs(front - oldFront); b = abs(height - oldHeight)
        tell("moved", 100*(a > b ? a : b)/L0)
    }
    tell("runout", 100*(runout/1.08 - 1))
    tell("height", 100*(height/(0.9*0.0972) - 1))
    if (asked("spin"))
    {
        for (f = 1; f <= 2; ++f) for (i = 0; i < number[f]; ++i)
            turn[f] += m(f, i)*((y(f, i) - 0.5)*Ux(f, i) \
                - (x(f, i) - 0.5)*Uy(f, i))
        tell("spin", 100*(turn[1]/turn[2] - 1))
    }
    if (asked("flow") && theta)
    {
        mus = tan(20.9*pi/180); mu2 = tan(32.76*pi/180); mu = tan(theta*pi/180)
        U0 = 2/3*0.279*(mu - mus)/(mu2 - mu)/5e-4 \
            *sqrt(0.6*g*cos(theta*pi/180))*H^1.5
        for (i = 0; i < N; ++i)
        {
            q = 1 - y(1, i)/H
            exact = U0*(1 - (q > 0 ? q : 0)^1.5)
            error += (Ux(1, i) - exact)^2 + Uy(1, i)^2
            norm += exact^2
        }
        tell("flow", 100*sqrt(error/norm))
    }
    else if (asked("flow"))
        tell("flow", 100*(mean < slowest ? 1 - mean/slowest : \
            mean > fastest ? mean/fastest - 1 : 0))
    if (asked("difference"))
    {
        sort(2)
        for (i = 0; i < N; ++i)
        {
            plane(2, x(1, i), y(1, i), -1)
            if (nearest > farthest) farthest = nearest
        }
        tell("difference", farthest)
    }
}
