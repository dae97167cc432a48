# What two runs over one terrain say, beside each other:
#
#     awk -v dx=0.0035 -v scale=0.002 -f verdicts.awk terrain.csv \
#         walls.vtp start.vtp end.vtp runout.dat \
#         walls.vtp start.vtp end.vtp runout.dat
#
# The .vtp files are ASCII. Fails if a particle is below the terrain, or mass is
# lost, or the two are farther apart than the bands: 1e-3 of a spacing for the
# particles of the wall, a spacing for the front, a tenth of it for the centre
# of mass.

FNR == 1 {
    file++; array = ""
    run = file < 6 ? 1 : 2; part = (file - 2) % 4       # of each run
}

file == 1 {
    split($0, column, ",")
    if (column[1] + 0 == column[1])
    {
        x[n] = scale*column[1]; z[n++] = scale*column[2]
    }
    next
}

# Time, t/tc, left and right front, ...
part == 3 {
    if (!/^#/) front[run] = $4
    next
}

/<DataArray/ {
    array = ""
    if (match($0, /Name="[^"]*"/)) array = substr($0, RSTART + 6, RLENGTH - 7)
    count = 0
    next
}
/</ { next }

array == "Points" && part == 0 {
    for (k = 1; k <= NF; k++)
    {
        if (run == 1) wall[count] = $k
        else apart = larger(apart, $k - wall[count], wall[count] - $k)
        count++
    }
}
array == "m" && part > 0 {
    for (k = 1; k <= NF; k++)
    {
        particleMass[count++] = $k
        mass[run, part] += $k
    }
}
array == "Points" && part == 2 {
    for (k = 1; k <= NF; k++)
    {
        r[count % 3] = $k
        if (++count % 3 == 0) particle(r[0], r[1], particleMass[count/3 - 1])
    }
}

function particle(px, py, m,    height)
{
    xc[run] += m*px; yc[run] += m*py
    height = py - terrain(px)
    if (height < 0) below[run]++
    if (least[run] == "" || height < least[run]) least[run] = height
}

# The last of two points at one place, the foot of the cliff, counts
function terrain(px,    low, high, middle)
{
    low = 0; high = n - 1
    while (high - low > 1)
    {
        middle = int((low + high)/2)
        if (x[middle] <= px) low = middle; else high = middle
    }
    return z[low] + (z[high] - z[low])*(px - x[low])/(x[high] - x[low])
}

function row(quantity, csv, stl, verdict)
{
    printf "%-44s%12s%12s   %s\n", quantity, csv, stl, verdict
    failed = failed || verdict == "FAIL"
}

function says(condition) { return condition ? "pass" : "FAIL" }

function larger(a, b, c)
{
    a = a > b ? a : b
    return a > c ? a : c
}

function within(a, b, band) { return a - b <= band && b - a <= band }

END {
    for (run = 1; run <= 2; run++)
    {
        m = mass[run, 2]
        xc[run] /= m; yc[run] /= m
        lost[run] = mass[run, 1] - m
        sound = m > 0 && lost[run] <= 1e-12*m && lost[run] >= -1e-12*m
        kept = run == 1 ? sound : kept && sound
    }
    printf "\n%-44s%12s%12s   %s\n", "quantity", "CSV", "STL", "verdict"
    row("particles of the wall apart by [m]", "-", sprintf("%.1e", apart),
        says(apart <= 1e-3*dx))
    row("particles below the terrain", below[1] + 0, below[2] + 0,
        says(below[1] + below[2] == 0))
    row("least height above it [mm]", sprintf("%.3f", 1e3*least[1]),
        sprintf("%.3f", 1e3*least[2]), "-")
    row("mass [kg/m]", sprintf("%.6f", mass[1, 2]),
        sprintf("%.6f", mass[2, 2]), "-")
    row("mass lost [kg/m]", sprintf("%.1e", lost[1]),
        sprintf("%.1e", lost[2]), says(kept))
    row("front [m]", sprintf("%.4f", front[1]), sprintf("%.4f", front[2]),
        says(within(front[1], front[2], dx)))
    row("centre of mass, x [m]", sprintf("%.5f", xc[1]),
        sprintf("%.5f", xc[2]), says(within(xc[1], xc[2], 0.1*dx)))
    row("centre of mass, y [m]", sprintf("%.5f", yc[1]),
        sprintf("%.5f", yc[2]), says(within(yc[1], yc[2], 0.1*dx)))
    exit failed
}
