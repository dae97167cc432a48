# What switching a term off or on does to the numbers of the tutorials:
#
#     awk -v tsv=<results.tsv> -f compare.awk terms -
#
# Reads of each scene 'number <quantity> <reference> <least change>', its runs
# 'run <term> <outcome>' with their numbers '<quantity> <value>', and 'end <scene>'.
# Prints a row a term, and appends a row a number to tsv.
#
# The change of a number is the difference of the means over the seeds, its scatter
# the standard deviation over the seeds of the base, at least half of the least change
# that matters. Above two scatters it counts; it is for the worse if it leads away
# from the reference. The cost is the least time of a step in the first three runs, as
# other programs only add to it, times the mean number of steps. A fifth of either
# counts, less may be those programs; of the steps what is above two scatters.
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
    split("", squares); split("", pace)
    next
}

{
    ++n[term, $1]
    sum[term, $1] += $2
    squares[term, $1] += $2^2
    if ($1 == "CPU") CPU = $2
    if ($1 == "steps" && $2 && runs[term] <= 3 && \
        (!(term in pace) || CPU/$2 < pace[term])) pace[term] = CPU/$2
}

function abs(a) { return a < 0 ? -a : a }
function larger(a, b) { return a > b ? a : b }
function mean(term, q) { return sum[term, q]/n[term, q] }

function scatter(q,    N, square)
{
    N = n["base", q]
    square = (squares["base", q] - sum["base", q]^2/N)/(N - 1)
    return square > 0 ? sqrt(square) : 0
}

function compare(scene, term,    k, q, s, change, worse, says, best, worst, harm,
    help, changes, verdict, added, time, steps, limit, slower, faster)
{
    added = state[term] == "on"
    if (term in fails)
    {
        tell(scene, term, added ? "would harm" : "needed", "-", "-", \
            fails[term], fails[term])
        return
    }
    for (k = 1; k <= Q; ++k)
    {
        q = quantities[k]
        s = larger(scatter(q), 0.5*least[q])
        change = mean(term, q) - mean("base", q)
        worse = abs(mean(term, q) - reference[q]) \
            - abs(mean("base", q) - reference[q])
        says = abs(change) <= 2*s ? "same" : worse > 0 ? "worse" : "better"
        if (says == "worse" && worse/s > worst)
        {
            worst = worse/s
            harm = sprintf("%s %+.1f", q, change/s)
        }
        if (says == "better" && -worse/s >= best)
        {
            best = -worse/s
            help = sprintf("%s %+.1f", q, change/s)
        }
        changes = changes sprintf("%s%s %+.1f", k > 1 ? "; " : "", q, change/s)
        row(scene, term, q, change, s, says)
    }
    steps = 100*(mean(term, "steps")/mean("base", "steps") - 1)
    time = (100 + steps)*pace[term]/pace["base"] - 100
    limit = larger(20, 200*scatter("steps")/mean("base", "steps"))
    slower = pace[term] > 1.2*pace["base"] || steps > limit
    faster = pace[term] < 0.8*pace["base"] || steps < -limit
    if (harm != "" && (help != "" || added && faster))
        verdict = added ? "would trade" : "trades"
    else if (harm != "") verdict = added ? "would harm" : "needed"
    else if (added && help != "") verdict = "would help"
    else if (added) verdict = faster ? "would buy speed" : "would buy nothing"
    else if (slower) verdict = "buys speed"
    else verdict = help != "" ? "harms" : "buys nothing"
    tell(scene, term, verdict, sprintf("%.0f", time), \
        sprintf("%.0f", steps), harm (harm != "" && help != "" ? "; " : "") help, changes)
}

function tell(scene, term, verdict, time, steps, decisive, changes)
{
    printf "%s,%s,%s,%s,%s,%s,%s,%s\n", scene, label[term], state[term], verdict, \
        time, steps, decisive, changes
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
