# What switching a term off or on does to the numbers of the tutorials:
#
#     awk -v tsv=<results.tsv> -f compare.awk terms -
#
# Reads of each scene 'number <quantity> <reference> <least change>', its runs
# 'run <term> <outcome>' with their numbers '<quantity> <value>', and 'end <scene>'. Prints a row a term, and appends a row a number to tsv.
#
# The change of a number is the difference of the means over the seeds, its scatter
# the standard deviation over the seeds of the base. A change counts if it is above
# two scatters and above the least one; it is for the worse if it leads away from
# the reference.
BEGIN {
    OFS = ","
    print "tutorial", "term", "state", "verdict", "CPU_percent", \
        "steps_percent", "decisive", "changes"
    OFS = "\t"
    print "figure", "quantity", "measured", "reference", "error %", "band %", \
        "verdict", "source" > tsv
}

FNR == NR {
    if ($2 != "label") next
    state[$1] = $3
    text = $0
    sub(/^[^ ]+ +label +[^ ]+ +/, "", text)
    label[$1] = text
    next
}

$1 == "number" {
    quantities[++Q] = $2
    reference[$2] = $3
    least[$2] = $4
    next
}

$1 == "run" {
    term = $2
    if (!(term in runs)) terms[++T] = term
    ++runs[term]
    if ($3 != "done")
    {
        outcome = $0
        sub(/^run [^ ]+ /, "", outcome)
        fails[term] = outcome
    }
    next
}

$1 == "end" {
    for (k = 2; k <= T; ++k) compare($2, terms[k])
    Q = T = 0
    split("", runs); split("", fails); split("", n); split("", sum)
    split("", squares)
    next
}

{
    ++n[term, $1]
    sum[term, $1] += $2
    squares[term, $1] += $2^2
}

function abs(a) { return a < 0 ? -a : a }
function mean(term, q) { return sum[term, q]/n[term, q] }

function scatter(q,    N, square)
{
    N = n["base", q]
    square = (squares["base", q] - sum["base", q]^2/N)/(N - 1)
    return square > 0 ? sqrt(square) : 0
}

function percent(term, q) { return 100*(mean(term, q)/mean("base", q) - 1) }

function compare(scene, term,    k, q, s, change, worse, says, best, worst, decisive,
    changes, verdict, added, cost)
{
    added = state[term] == "on"
    for (k = 1; k <= Q && !(term in fails); ++k)
    {
        q = quantities[k]
        s = scatter(q)
        if (s < 0.5*least[q]) s = 0.5*least[q]
        change = mean(term, q) - mean("base", q)
        worse = abs(mean(term, q) - reference[q]) \
            - abs(mean("base", q) - reference[q])
        says = abs(change) <= 2*s ? "same" : worse > 0 ? "worse" : "better"
        if (says == "worse" && worse/s > worst)
        {
            worst = worse/s
            decisive = sprintf("%s %+.1f", q, change/s)
        }
        if (says == "better" && -worse/s > best)
        {
            best = -worse/s
            if (!worst) decisive = sprintf("%s %+.1f", q, change/s)
        }
        changes = changes sprintf("%s%s %+.1f", k > 1 ? "; " : "", q, change/s)
        row(scene, term, q, change, s, says)
    }
    cost = percent(term, "CPU")
    if (term in fails)
    {
        verdict = "needed"
        if (added) verdict = "would harm"
        decisive = changes = fails[term]
    }
    else if (worst) verdict = added ? "would harm" : "needed"
    else if (best) verdict = added ? "would help" : "harms"
    else if (added && cost < -10) verdict = "would buy speed"
    else if (!added && cost > 10) verdict = "buys speed"
    else verdict = added ? "would buy nothing" : "buys nothing"
    if (worst && best) changes = changes "; in part better"
    printf "%s,%s,%s,%s,%.0f,%.0f,%s,%s\n", scene, label[term], \
        state[term], verdict, cost, percent(term, "steps"), decisive, changes
}

# As the studies of validation have them: off or on, base, twice the scatter
function row(scene, term, q, change, s, says,    base)
{
    base = mean("base", q)
    print scene ", " (state[term] == "on" ? "with " : "without ") label[term], q, \
        sprintf("%.5g", mean(term, q)), sprintf("%.5g", base), \
        base ? sprintf("%.3g", 100*change/abs(base)) : "-", \
        base ? sprintf("%.3g", 200*s/abs(base)) : "-", says, \
        "the tutorial, mean of " n["base", q] " starts" > tsv
}
