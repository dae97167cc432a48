# A profile (columns x and z) as a surface in space, in triangles of STL whose
# normals point upwards, from y = -width/2 to width/2.
#     awk -F, -v width=100 -f extrude.awk terrain.csv > terrain.stl

function vertex(x, y, z)
{
    printf "      vertex %s %s %s\n", x, y, z
}

function facet(x1, y1, z1, x2, y2, z2, x3, y3, z3)
{
    print "  facet normal 0 0 0\n    outer loop"
    vertex(x1, y1, z1); vertex(x2, y2, z2); vertex(x3, y3, z3)
    print "    endloop\n  endfacet"
}

BEGIN { print "solid terrain"; y = width/2 }
/^#/ || $1 + 0 != $1 { next }
n++ {
    facet(x, -y, z, $1, -y, $2, $1, y, $2)
    facet(x, -y, z, $1, y, $2, x, y, z)
}
{ x = $1; z = $2 }
END { print "endsolid terrain" }
