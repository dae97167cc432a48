# One row of results.tsv for run-out and one for height, from the summary.dat of
# a postRunout, against the regression of the measured points:
#
#     (Lf - L0)/L0 = 1.81 a  (a < 3),  2.67 a^(2/3)  (a > 3);  scatter 12, 14 %
#     Hf/L0        = a  (a < 0.7),     0.90 a^(1/3)  (a > 0.7);  scatter 5 %
#
# and, with the last profile, one without a band for the run-out of the layer that
# is 1.5 d thick. curves.awk stands in etc.
#
#     awk -v a=1 -v n=40 [-v L0=0.102] -f curves.awk -f compare.awk \
#         summary.dat [profile_<time>.dat]
function row(quantity, measured, reference, band,    error)
{
    error = 100*(measured/reference - 1)
    printf "Lajeunesse, a = %s, n = %s\t%s\t%.4f\t%.4f\t%.2f\t%s\t%s\t%s\n", \
        a, n, quantity, measured, reference, error, band, \
        band == "-" ? "-" : (error^2 <= band^2 ? "pass" : "FAIL"), \
        "regression of the measured points"
}

BEGIN { runout = a < 3 ? 1.81*a : 2.67*a^(2/3) }

/^ *#/ { next }

$1 == "runout" { row("run-out", $3, runout, 7) }
$1 == "height" { row("height", $3, a < 0.7 ? a : 0.9*a^(1/3), 5) }

FNR != NR { add("last", $1, $2) }

END {
    if (size["last"])
        row("run-out, 1.5 d thick", front("last", 1.5*0.00115)/L0 - 1, \
            runout, "-")
}
