# Rows of several starts (see compare.awk) -> one of each quantity, of their mean,
# with its verdict; behind its source stands their scatter (standard deviation)
BEGIN { FS = OFS = "\t" }

!($2 in count) { order[++rows] = $2 }

{
    count[$2]++
    sum[$2] += $3
    squares[$2] += $3^2
    line[$2] = $0
}

END {
    for (r = 1; r <= rows; r++)
    {
        $0 = line[order[r]]
        n = count[$2]
        mean = sum[$2]/n
        variance = n > 1 ? (squares[$2] - n*mean^2)/(n - 1) : 0
        $3 = sprintf("%.4f", mean)
        if ($4 ~ /^at most/)
        {
            limit = substr($4, 9)
            if ($7 != "-") $7 = $3 + 0 <= limit + 0 ? "pass" : "FAIL"
        }
        else if ($4 != "-")
        {
            error = 100*(mean/$4 - 1)
            $5 = sprintf("%.2f", error)
            if ($7 != "-") $7 = error^2 <= $6^2 ? "pass" : "FAIL"
        }
        if ($8 !~ /^grains \(/ || $2 !~ /Basilisk/)
        {
            $8 = sprintf("%s; mean of %d starts, scatter %.4f", $8, n, \
                sqrt(variance > 0 ? variance : 0))
        }
        print
    }
}
