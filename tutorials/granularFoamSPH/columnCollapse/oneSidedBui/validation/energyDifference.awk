# Kinetic plus potential energy beside that of SPHinXsys [J/m]:
#
#     awk -f energyDifference.awk energy.csv energies.dat

/^ *#/ || /^[a-z]/ { next }

{ gsub(/,/, " ") }

FNR == NR { t[++n] = $1; theirs[n] = $2; k = 1; next }

# Time, kinetic, potential since the start: at each of the times t
{
    now = $2 + $3 + theirs[1]
    for (; k <= n && t[k] <= $1; k++)
    {
        w = $1 > before ? (t[k] - before)/($1 - before) : 1
        ours[k] = (1 - w)*last + w*now
    }
    before = $1
    last = now
}

END {
    print "Kinetic plus potential energy [J/m]\n"
    print "  t [s]   this run   SPHinXsys"
    for (i = 1; i < k; i++)
    {
        difference = ours[i] - theirs[i]
        if (difference < 0) difference = -difference
        if (difference > largest) largest = difference
        if (i % 6 == 1 || i == n)
        {
            printf "%7.3f%11.3f%12.3f\n", t[i], ours[i], theirs[i]
        }
    }
    printf "\nLargest difference: %.1f %% of the energy released\n",
        100*largest/(theirs[1] - theirs[n])
}
