# Of the last particles, read by read.awk: H, rho0 and dx are given
END {
    for (i = 0; i < number[1]; ++i)
    {
        mass += m(1, i)
        right += m(1, i)*x(1, i)
        up += m(1, i)*y(1, i)
    }
    g = 9.81
    print "speed", 100*speed(1)/sqrt(g*H)
    print "roughness", 100*roughness(1)/(rho0*g*H)
    print "x", right/mass/H
    print "y", up/mass/H
}
