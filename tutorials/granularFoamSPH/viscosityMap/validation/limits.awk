# Eq. 38 against the map, wherever the regularisation is negligible: the greatest
# error over gammaDot >= 0.1/s, and for the cap where Eq. 38 is below it
BEGIN {
    OFS = "\t"; pi = atan2(0, -1)
    mus = sin(20.9*pi/180)/cos(20.9*pi/180)
    mu2 = sin(32.76*pi/180)/cos(32.76*pi/180)
    xi = 0.279/(5e-4*sqrt(2600))
}
/^#/ { next }
{
    p = $1; rate = $2
    eta = mus*p/rate + (mu2 - mus)*p/(rate + xi*sqrt(p))
    if (rate < 0.1 || (name == "cap" && eta > 1.5)) next
    error = 100*($3/eta - 1)
    if (error^2 >= worst^2) { worst = error; measured = $3; reference = eta }
    n++
}
END {
    print "Fig. 2, " name, "eta [Pa s]", measured, reference, worst, 0.1, \
        (n > 100 && worst^2 < 0.01 ? "pass" : "FAIL"), \
        "Eq. 38, worst of " n " points"
}
