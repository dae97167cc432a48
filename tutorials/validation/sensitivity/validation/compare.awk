# From the numbers of all runs of one scene, rows of results.tsv, a table in
# Markdown and the columns of the picture:
#
#     awk -v table=table.md -v columns=changes.dat -f compare.awk \
#         runs/<scene>n<n>_<entry>_<value>_s<seed>/rows.tsv ... >> results.tsv
#
# Numbers with a band b only: of its reference, or the limit of an RMS. Scatter:
# standard deviation over the disordered starts. Change by a constant or the
# spacing: mean of the differences to the base with the same disordered start.
# Change by the order: a start on the square or the hexagonal lattice against the
# mean of those in disorder.

BEGIN { FS = "\t" }

FNR == 1 {
    split(FILENAME, folder, "/")
    split(folder[2], part, "_")
    entry = part[2]
    factor = entry == "lattice" ? 0 : part[3] + 0
    seed = substr(part[4], 2) + 0
    base = entry == "base"
    if (!(entry in known) && !base && entry != "lattice")
    {
        known[entry] = ++entries
        name[entries] = entry
    }
    if (base && !seed) scene = $1
    if (!base && index(" " values[entry] " ", " " factor " ") == 0)
    {
        values[entry] = values[entry] " " factor
    }
}

base && !seed && $7 != "-" {
    Q[++quantities] = $2
    band[$2] = $6 == "-" ? substr($4, 9) + 0 : $6/100*$4
}

{ number[$2, entry, factor, seed] = $3 }

function short(q)
{
    sub(/ of the surface at/, "", q)
    sub(/x of 98 % of the area at/, "x98", q)
    sub(/ \[H0\]/, "", q)
    sub(/ thick, at 6 tc/, "", q)
    sub(/runout/, "run-out", q)
    return q
}

function statistics(q,    s, n, x, sum, squares)
{
    for (s = 1; (q, "base", 1, s) in number; s++)
    {
        x = number[q, "base", 1, s] - number[q, "base", 1, 1]
        n++
        sum += x
        squares += x*x
    }
    mean = number[q, "base", 1, 1] + sum/n
    scatter = sqrt((squares - sum*sum/n)/(n - 1))
}

# With this value of the entry
function change(q, e, v,    s, n, sum)
{
    for (s = 1; (q, e, v, s) in number; s++)
    {
        n++
        sum += number[q, e, v, s] - number[q, "base", 1, s]
    }
    return n ? sum/n : "none"
}

function abs(x) { return x < 0 ? -x : x }

function row(q, what, measured, verdict, from)
{
    printf "Sensitivity, %s\t%s: %s\t%.4f\tless than %.4f\t-\t-\t%s\t%s\n", \
        scene, short(q), what, measured, band[q], verdict, from
}

function verdict(q, x) { return abs(x) < band[q] ? "pass" : "FAIL" }

# In scatters; bold if more than the band
function cell(q, x,    text)
{
    text = sprintf("%+.1f", x/scatter)
    return abs(x) < band[q] ? text : "**" text "**"
}

END {
    head = "| " scene " | square | mean | scatter | band | square | hexagonal"
    line = "|---|---|---|---|---|---|---"
    for (k = 1; k <= entries; k++)
    {
        head = head " | " name[k] values[name[k]]
        line = line "|---"
    }
    print head " |\n" line "|" >> table
    for (i = 1; i <= quantities; i++)
    {
        q = Q[i]
        statistics(q)
        order = number[q, "base", 1, 0] - mean
        row(q, "scatter of starts", scatter, verdict(q, scatter), \
            sprintf("mean %.4f", mean))
        row(q, "square lattice", order, verdict(q, order), \
            sprintf("%+.1f scatters", order/scatter))
        hexagonal = "none"
        if ((q, "lattice", 0, 0) in number)
        {
            hexagonal = number[q, "lattice", 0, 0] - mean
            row(q, "hexagonal lattice", hexagonal, verdict(q, hexagonal), \
                sprintf("%+.1f scatters", hexagonal/scatter))
        }
        cells = sprintf("| %s | %.4f | %.4f | %.4f | %.4f | %s | %s", short(q), \
            number[q, "base", 1, 0], mean, scatter, band[q], cell(q, order), \
            hexagonal == "none" ? "-" : cell(q, hexagonal))
        bar[-2, i] = scatter/band[q]
        bar[-1, i] = abs(order)/band[q]
        bar[0, i] = hexagonal == "none" ? "-" : abs(hexagonal)/band[q]
        for (k = 1; k <= entries; k++)
        {
            n = split(values[name[k]], list, " ")
            most = 0
            text = said = ""
            for (j = 1; j <= n; j++)
            {
                x = change(q, name[k], list[j])
                if (x == "none") continue
                if (abs(x) > abs(most)) most = x
                text = text (j > 1 ? ", " : "") cell(q, x)
                said = said (j > 1 ? ", " : "") sprintf("%+.1f", x/scatter)
            }
            row(q, name[k] values[name[k]], most, verdict(q, most), \
                said " scatters")
            cells = cells " | " text
            bar[k, i] = abs(most)/band[q]
        }
        print cells " |" >> table
    }
    print "" >> table

    text = "\"" scene "\""
    for (i = 1; i <= quantities; i++) text = text " \"" short(Q[i]) "\""
    print text >> columns
    name[-2] = "scatter"
    name[-1] = "square"
    name[0] = "hexagonal"
    for (k = -2; k <= entries; k++)
    {
        text = name[k]
        for (i = 1; i <= quantities; i++) text = text " " bar[k, i]
        print text >> columns
    }
    print "\n" >> columns
}
