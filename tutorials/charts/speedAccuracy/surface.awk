# RMS difference of two surfaces in a scale, and the errors of front and height:
#     awk -v scale=<length> -f surface.awk <summary> <profile> <summary> <profile>
# the reference first. At 400 places, by linear interpolation, wherever one of the
# two is not zero.
FNR == 1 { ++file }

/^ *#/ { next }

file % 2 == 1 {
    if ($1 == "runout") runout[file] = $3
    if ($1 == "height") height[file] = $3
    next
}

$1 >= 0 {
    n = ++size[file]
    X[file, n] = $1
    H[file, n] = $2
    if ($2 > 0 && $1 > longest) longest = $1
}

function at(curve, x,    n, i, w)
{
    n = size[curve]
    if (x <= X[curve, 1]) return H[curve, 1]
    if (x >= X[curve, n]) return 0
    for (i = 2; X[curve, i] < x; i++);
    w = (x - X[curve, i - 1])/(X[curve, i] - X[curve, i - 1])
    return (1 - w)*H[curve, i - 1] + w*H[curve, i]
}

END {
    for (k = 0; k < 400; k++)
    {
        x = (k + 0.5)*longest/400
        one = at(2, x)
        other = at(4, x)
        if (one > 0 || other > 0)
        {
            ++m
            sum += (one - other)^2
        }
    }
    print sqrt(sum/m)/scale, 100*(runout[3]/runout[1] - 1), \
        100*(height[3]/height[1] - 1)
}
