# What can be on the front of a scene: all of its runs that have come to their
# end, the reference excepted
BEGIN { FS = OFS = "," }

$1 == scene && $2 != reference && $6 ~ /^[0-9]/ { print $5, $6, $2, $3 }
