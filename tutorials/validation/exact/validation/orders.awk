# results.tsv of errors.tsv (scene, variants, n, quantity, error %, band %): a
# verdict a row, and the order observed since the spacing before,
#     log(error/error before)/log(n before/n)
BEGIN {
    FS = OFS = "\t"
    print "figure", "quantity", "measured", "reference", "error %", "band %", \
        "verdict", "source"
}
{
    name = $1 ($2 == "-" ? "" : " " $2)
    key = name FS $4
    order = "exact"
    e = $5 < 0 ? -$5 : $5
    if ($5 != "-" && key in before && before[key] > 0 && e > 0 && $3 != n[key])
        order = sprintf("exact; order %.2f", \
            log(before[key]/e)/log($3/n[key]))
    print name ", n = " $3, $4, "-", "-", $5, $6, \
        $5 == "-" ? "FAIL" : $6 == "-" ? "-" : e <= $6 + 0 ? "pass" : "FAIL", \
        order
    before[key] = $5 == "-" ? 0 : e
    n[key] = $3
}
