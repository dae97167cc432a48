# Curves by their points, and what differs between two of them; before a script
# that uses them:
#     awk -f "$SPH_PROJECT_DIR/etc/curves.awk" -f compare.awk ...
#
# Point k of a curve is (X[curve, k], H[curve, k]), k = 1 ... size[curve], in the
# order of x. Of several with one x the highest counts.

function add(curve, x, h,    n)
{
    n = size[curve]
    if (n && x == X[curve, n])
    {
        if (h > H[curve, n]) H[curve, n] = h
        return
    }
    size[curve] = ++n
    X[curve, n] = x
    H[curve, n] = h
}

# Linear between points, constant before the first, zero behind the last
function at(curve, x,    n, i, w)
{
    n = size[curve]
    if (x <= X[curve, 1]) return H[curve, 1]
    if (x >= X[curve, n]) return 0
    for (i = 2; X[curve, i] < x; i++);
    w = (x - X[curve, i - 1])/(X[curve, i] - X[curve, i - 1])
    return (1 - w)*H[curve, i - 1] + w*H[curve, i]
}

# RMS in the middle of bins from x = 0, wherever one of the two exceeds zero
function difference(one, other, width, bins, zero,    k, x, h1, h2, m, sum)
{
    for (k = 0; k < bins; k++)
    {
        x = (k + 0.5)*width
        h1 = at(one, x)
        h2 = at(other, x)
        if (h1 > zero || h2 > zero)
        {
            m++
            sum += (h1 - h2)^2
        }
    }
    return m ? sqrt(sum/m) : 0
}

# The farthest x of this height
function front(curve, h,    i)
{
    for (i = size[curve]; i > 1 && H[curve, i] < h; i--);
    if (i == size[curve]) return X[curve, i]
    return X[curve, i] + (X[curve, i + 1] - X[curve, i]) \
        *(H[curve, i] - h)/(H[curve, i] - H[curve, i + 1])
}
