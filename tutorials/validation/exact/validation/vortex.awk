# Files: the last particles, energies.dat
#     E = E0 exp(-4 nu k^2 t),  U = exp(-2 nu k^2 t) (sin kx cos ky, ...)
FILENAME ~ /energies/ && !/^#/ { if (E0 == "") E0 = $2; t = $1; E = $2 }
END {
    k = 2*pi; nu = 0.01; dx = 1/n
    decay = exp(-2*nu*k*k*t)
    for (i = 0; i < number[1]; ++i)
    {
        X = k*x(1, i); Y = k*y(1, i)
        u = decay*sin(X)*cos(Y)
        v = -decay*cos(X)*sin(Y)
        error += (Ux(1, i) - u)^2 + (Uy(1, i) - v)^2
        norm += u*u + v*v
        pe = decay^2/4*(cos(2*X) + cos(2*Y))
        d = p(1, i) - pe
        s1 += d; s2 += d*d; e1 += pe*pe
    }
    N = number[1]
    row("rate of decay of E", 100*(log(E0/E)/(4*nu*k*k*t) - 1), 80/n)
    row("U, L2", 100*sqrt(error/norm), 160/n)
    row("p without its mean, L2", 100*sqrt((s2 - s1*s1/N)/e1), "-")
    row("roughness, of rho U^2/4 at the end", 100*roughness(1)/(decay^2/4), "-")
}
