# Files: the particles at the start, at w t = 0.05 and at 2
#     p = x^2 - x + sum 8/(m pi)^3 sin(m pi x) cosh(m pi (y - 1/2))/cosh(m pi/2)
# over odd m, in rho w^2 L^2: the double series summed over n; turned by w t.
function cosh(a) { return (exp(a) + exp(-a))/2 }
function series(X, Y,    j, s)
{
    s = X*X - X
    for (j = 1; j < 12; j += 2)
        s += 8/(j*pi)^3*sin(j*pi*X)*cosh(j*pi*(Y - 0.5))/cosh(j*pi/2)
    return s
}
function moments(f,    i, X, Y)
{
    spin = energy = inertia = 0
    for (i = 0; i < number[f]; ++i)
    {
        X = x(f, i) - 0.5
        Y = y(f, i) - 0.5
        spin += m(f, i)*(Y*Ux(f, i) - X*Uy(f, i))
        energy += m(f, i)*(Ux(f, i)^2 + Uy(f, i)^2)/2
        inertia += m(f, i)*(X*X + Y*Y)
    }
}
END {
    dx = 1/n
    c = cos(0.05); s = sin(0.05)
    for (i = 0; i < number[2]; ++i)
    {
        X = x(2, i) - 0.5; Y = y(2, i) - 0.5
        exact = series(0.5 + c*X - s*Y, 0.5 + s*X + c*Y)
        error += (p(2, i) - exact)^2
        norm += exact^2
    }
    rough = roughness(2)
    row("p at w t = 0.05, L2", 100*sqrt(error/norm), 80/n)
    row("p in the centre", 100*(plane(2, 0.5, 0.5)/series(0.5, 0.5) - 1), 80/n)
    row("roughness, of p in the centre", 100*rough/0.1473, "-")
    moments(1)
    spin0 = spin; energy0 = energy; inertia0 = inertia
    moments(3)
    row("angular momentum at 2/w", 100*(spin/spin0 - 1), 1)
    row("kinetic energy at 2/w", 100*(energy/energy0 - 1), 1)
    row("moment of inertia at 2/w, over dust's", \
        100*inertia/inertia0/5, "-")
    sort(3)
    for (i = 0; i < number[3]; ++i)
    {
        plane(3, x(3, i), y(3, i), i)
        if (neighbours < 4) ++lonely
    }
    row("particles with less than four neighbours", 100*lonely/number[3], "-")
}
