# Flows along x that vary with y. Files: the last particles, reference.dat
# variables: scene, n, variant
FILENAME ~ /reference/ && !/^#/ { L2[$2] = $5; last = $2 }
END {
    H = scene == "creep" ? 0.05 : scene == "channel" ? 1 : 0.02
    p0 = scene == "shear" ? 300 : scene == "chute" ? 500 : \
        scene == "channel" ? 1 : \
        1500*9.81*H*cos((scene == "creep" ? 15 : 24)*pi/180)
    dx = H/n
    band = 20/n
    if (variant ~ /plastic/)
    {
        for (i = 0; i < number[1]; ++i) if (Ux(1, i) > top) top = Ux(1, i)
        row("greatest speed, of the regularised law's", 100*top/0.53969, 1)
    }
    else if (scene == "bagnold" && variant ~ /start/)
    {
        split("0.2 0.8 3.2", date, " ")
        for (k = 1; k <= 3; ++k) for (t in L2)
            if (abs(t/date[k] - 1) < 0.01)
                row("U at " date[k] " s, L2", L2[t], band)
    }
    else
    {
        if (scene == "chute") for (t in L2)
            if (abs(t/0.05 - 1) < 0.1) row("U at 0.05 s, L2", L2[t], band)
        row(scene == "chute" ? "U at 0.25 s, L2" : "U, L2", L2[last], band)
    }
    for (i = 0; i < number[1]; ++i)
    {
        if (scene == "shear" && (y(1, i) < 2*dx || y(1, i) > H - 2*dx)) continue
        pressure += p(1, i)/number[1]
        tau += sxy(1, i)
        sum += p(1, i)
        ++inner
    }
    if (scene == "shear")
    {
        mus = tan(20.9*pi/180)
        mu2 = tan(32.76*pi/180)
        pressure = sum/inner
        I = 5e-4*20/sqrt(pressure/2500)
        mu = mus + (mu2 - mus)*I/(0.279 + I)
        row("tau/(mu(I) p)", 100*(tau/sum/mu - 1), 1)
    }
    if (scene == "shear" || scene == "chute")
        row("p, mean", 100*(pressure/p0 - 1), 5)
    row("roughness, of p0 or at the bed", 100*roughness(1)/p0, "-")
}
