# Creep of the regularised mu(I), Eq. 39 of Salehizadeh & Shafiei, Granular
# Matter 21:32 (2019), on a plane of 15 deg below mu_s = tan 20.9: at every depth
#
#     mu_s (1 - exp(-G/alphar)) + (mu_2 - mu_s) G/(xi sqrt(p) + G) = tan 15
#
# by bisection, and u = int G dy by Simpson's rule. The factor of alphas,
# 1 - 1e-14 here, is left out.
#     awk -f creep.awk > creep.csv
function tan(x) { return sin(x)/cos(x) }
function rate(depth,    p, low, high, G)
{
    p = 1500*9.81*cos(15*degree)*depth
    for (low = 0; high - low > 1e-12 || high == ""; )
    {
        if (high == "") high = 100
        G = (low + high)/2
        if (mus*(1 - exp(-G/10)) + (mu2 - mus)*(p > 0 ? G/(xi*sqrt(p) + G) : 1) \
            < tan(15*degree)) low = G
        else high = G
    }
    return low
}
BEGIN {
    degree = atan2(0, -1)/180
    mus = tan(20.9*degree); mu2 = tan(32.76*degree)
    xi = 0.279/(5e-4*sqrt(2500))
    H = 0.05; N = 2000
    print "# Creep below yield: validation/creep.awk; H = 50 mm, alphar = 10 1/s"
    print "y_m,u_m_s,rate_1_s"
    for (i = 0; i <= N; ++i)
    {
        y = H*i/N
        if (i) u += H/N/6*(rate(H - y + H/N) + 4*rate(H - y + H/N/2) + rate(H - y))
        if (i % 50 == 0) printf "%.5f,%.7f,%.5f\n", y, u, rate(H - y)
    }
}
