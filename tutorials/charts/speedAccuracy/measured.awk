# Runs of the named settings of one scene, as etc/charts/measured has them:
#     awk -v scene=... -v kind=... -v aspect=... -v height=... -v seconds=... \
#         -v against=... -f measured.awk runs.csv
# seconds: what a run simulates. Across are the particles along the smaller side;
# on an incline, the layers.
BEGIN {
    FS = ","
    printf "\n%s\n{\n    kind        %s;\n    aspect      %s;\n", \
        scene, kind, aspect
    printf "    duration    %.3g;\n", seconds/sqrt(height/9.81)
    printf "    reference   \"%s\";\n    runs\n    (\n", against
}

function optional(name, value)
{
    return value ~ /[0-9]/ ? sprintf(" %s %.3g;", name, value) : ""
}

$1 == scene && $3 ~ /^(fast|balanced|accurate)$/ && $6 ~ /^[0-9]/ {
    across = kind == "incline" ? $2 \
        : int(sqrt($4*(aspect < 1 ? aspect : 1/aspect)) + 0.5)
    printf "        {\n            setting %s; across %d; particles %d;", \
        $3, across, $4
    printf " time %.3g;\n            error %.3g;%s%s\n        }\n", $5, 100*$6, \
        optional("front", $7), optional("height", $8)
}

END { print "    );\n}" }
