# What a collapse on a plane says beside theory and experiment:
#
#     awk -v theta=10 -f verdicts.awk summary.dat runout.dat
#
# Prints quantity, measured, reference, error, band and verdict, and appends
# them to results.tsv. Fails if there is nothing to judge.

function row(quantity, measured, reference, error, band, verdict, source)
{
    printf "%-38s%10s%11s%9s%8s   %s\n",
        quantity, measured, reference, error, band, verdict
    printf "Figs 6-8, theta = %s deg\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n",
        theta, quantity, measured, reference, error, band, verdict, source \
        >> "results.tsv"
}

function beside(quantity, measured, law, band, source,    error)
{
    error = 100*(measured/law - 1)
    row(quantity, sprintf("%.4f", measured), sprintf("%.4f", law),
        sprintf("%+.1f", error), sprintf("%g", band),
        error <= band && error >= -band ? "pass" : "FAIL", source)
}

BEGIN {
    L0 = 0.2; H0 = 0.14; mus = 20.9; rad = atan2(0, -1)/180
    print "\ntheta = " theta " deg\n"
    printf "%-38s%10s%11s%9s%8s   %s\n", "quantity", "measured",
        "reference", "error %", "band %", "verdict"
}

/^ *#/ { next }

FNR == NR { law[$1] = $4; band[$1] = $6; next }

# Time, t/tc, left and right front, run-out, height
{
    time = $1; front = $4; height = $6
    if (front != front + 0 || front <= 0) exit bad = 1
    n++
    times[n] = time
    fronts[n] = front
    if (time <= 1.0001) thicknessAt1s = height
}

END {
    experiment = "Mangeney et al. 2010, fits for horizontal planes"
    paper = "Salehizadeh & Shafiei 2019, Sec. 6.1"
    if (law["runout"] != "nan")
    {
        beside("run-out from the gate [m]", front - L0, L0*law["runout"],
            band["runout"], experiment)
        beside("greatest thickness, end [m]", height, L0*law["height"],
            band["height"], experiment)
    }
    else
    {
        row("run-out from the gate [m]", sprintf("%.4f", front - L0),
            "-", "-", "-", "-", "no numbers published")
        row("greatest thickness, end [m]", sprintf("%.4f", height),
            "-", "-", "-", "-", "no numbers published")
    }

    # mu(I): rest where tan(theta) < mus, at any thickness; flow above it
    # Over the last five outputs
    if (bad || n < 6) exit 1
    speed = (fronts[n] - fronts[n - 5])/(times[n] - times[n - 5])
    limit = 0.01*sqrt(9.81*H0)
    moves = speed > limit || speed < -limit
    row(sprintf("front speed at %.2f s [m/s]", time), sprintf("%.4f", speed),
        sprintf("%s %.4f", theta > mus ? ">" : "<", limit), "-", "-",
        moves == (theta > mus) ? "pass" : "FAIL",
        "mu(I): " (theta > mus ? "flows" : "stops") \
        ", as mus = tan 20.9 deg; limit 0.01 sqrt(g h0)")
    if (theta == 22)
    {
        row("greatest thickness at 1 s [m]",
            sprintf("%.4f", thicknessAt1s), "about 0.05", "-", "-", "-",
            paper ", at no stated time")
    }
}
