# Phases of the front: the trapezoid of front speed against time (rising for t1,
# constant for t2, falling for t3) whose integral fits x(t) best.
#     awk -f frontPhases.awk -v l0=.. -v out=front.dat runout.dat
# Prints t1 t2 t3 [tc], the constant speed over sqrt(g h0), the root mean square
# of the misfit over the run-out, and that of the experiment's trapezoid (0.8, 2,
# 0.6) with the run-out measured. Writes t/tc, (l - l0)/l0 and the fit to out.

function fit(t)
{
    if (t < t1) return V*t*t/(2*t1)
    if (t < t1 + t2) return V*(t - t1/2)
    if (t < t1 + t2 + t3) return V*(t1/2 + t2 + (t - t1 - t2)*(1 - (t - t1 - t2)/(2*t3)))
    return total
}

/^#/ { next }
{
    if (!n) x0 = $4
    # A run that was interrupted tells of some times twice
    while (n && time[n - 1] >= $2) n--
    time[n] = $2; x[n] = ($4 - x0)/l0; n++
}
END {
    total = x[n - 1]
    step = n > 150 ? int(n/150) : 1
    best = 1e30
    for (i = 2; i <= 20; i++)
        for (j = 0; j <= 40; j++)
            for (l = 2; l <= 60; l++)
            {
                t1 = i/10; t2 = j/10; t3 = l/10
                V = total/(t1/2 + t2 + t3/2)
                sum = 0
                for (k = 0; k < n && sum < best; k += step)
                    sum += (x[k] - fit(time[k]))^2
                if (sum < best) { best = sum; b1 = t1; b2 = t2; b3 = t3 }
            }
    t1 = b1; t2 = b2; t3 = b3
    V = total/(t1/2 + t2 + t3/2)
    print "# t/tc (l-l0)/l0 fit" > out
    for (k = 0; k < n; k += step) print time[k], x[k], fit(time[k]) > out
    speed = V
    t1 = 0.8; t2 = 2; t3 = 0.6
    V = total/(t1/2 + t2 + t3/2)
    for (k = 0; k < n; k += step)
    {
        m++
        sumExperiment += (x[k] - fit(time[k]))^2
    }
    printf "%.2f %.2f %.2f %.3f %.4f %.4f\n", b1, b2, b3, speed, \
        sqrt(best/m)/total, sqrt(sumExperiment/m)/total
}
