# Files: the last particles, energies.dat. The momentum along x goes as
# cos(omega t) exp(-2 nu k^2 t): frequency of its zeros, decay of its extremes,
# each of a parabola through the greatest sample.
FILENAME ~ /energies/ && !/^#/ { t[++N] = $1; q[N] = $7 }
END {
    k = pi; H = 0.5; g = 9.81; nu = 0.005; dx = 1/n
    th = (exp(2*k*H) - 1)/(exp(2*k*H) + 1)
    omega = sqrt(g*k*th)
    for (i = 2; i <= N; ++i) if (q[i - 1]*q[i] < 0)
    {
        zero = t[i - 1] + (t[i] - t[i - 1])*q[i - 1]/(q[i - 1] - q[i])
        if (!zeros++) first = zero
    }
    measured = pi*(zeros - 1)/(zero - first)
    # log of the amplitude of each half period against its time, by a line
    for (i = 1; i <= N; ++i)
    {
        half = int(measured*(t[i] - first)/pi + 1)
        if (t[i] < first) continue
        if (abs(q[i]) > top[half]) { top[half] = abs(q[i]); at[half] = t[i] }
    }
    for (h = 1; h < zeros; ++h)
    {
        a = at[h]; b = log(top[h])
        s += 1; sa += a; sb += b; saa += a*a; sab += a*b
    }
    rate = -(s*sab - sa*sb)/(s*saa - sa*sa)
    row("frequency", 100*(measured/omega - 1), 1)
    row("rate of decay", 100*(rate/(2*nu*k*k) - 1), 10)
    row("roughness, of rho g H", 100*roughness(1)/(1000*g*H), "-")
}
