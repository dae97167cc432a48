# Files: the last particles
#     p = K (exp(rho0 g (H - y)/K) - 1), U = 0
END {
    g = 9.81; rho0 = 1612; H = 0.1; dx = H/n; K = 100*rho0*g*H
    for (i = 0; i < number[1]; ++i)
    {
        exact = K*(exp(rho0*g*(H - y(1, i))/K) - 1)
        error += (p(1, i) - exact)^2
        norm += exact^2
        sum += exact
        carried += p(1, i) - value[1, "s", 6*i + 1]
        if (y(1, i) > top) top = y(1, i)
    }
    row("speed, RMS, of sqrt(g H)", 100*speed(1)/sqrt(g*H), 0.1)
    row("pressure, L2", 100*sqrt(error/norm), 20/n)
    row("vertical stress, mean", 100*(carried/sum - 1), 1)
    row("height", 100*((top + dx/2)/H - 1), 0.5)
    row("roughness, of rho g H", 100*roughness(1)/(rho0*g*H), "-")
}
