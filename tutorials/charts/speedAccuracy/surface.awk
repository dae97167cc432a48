# RMS difference of two surfaces in a scale, and the errors of front and height:
#     awk -v scale=<length> -f curves.awk -f surface.awk \
#         <summary> <profile> <summary> <profile>
# the reference first. At 400 places, by linear interpolation, wherever one of the
# two is not zero.
FNR == 1 { ++file }

/^ *#/ { next }

file % 2 == 1 {
    if ($1 == "runout") runout[file] = $3
    if ($1 == "height") height[file] = $3
    next
}

$1 >= 0 {
    add(file, $1, $2)
    if ($2 > 0 && $1 > longest) longest = $1
}

END {
    print difference(2, 4, longest/400, 400, 0)/scale, \
        100*(runout[3]/runout[1] - 1), 100*(height[3]/height[1] - 1)
}
