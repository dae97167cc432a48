#include "geometry/CutPlane.H"

namespace sph
{

static Eigen::Vector3d read
(
    const dictionary& dict, const Key& key, const std::vector<scalar>& value
)
{
    const auto given = dict.getOrDefault<std::vector<scalar>>(key, value);
    if (given.size() != 3)
    {
        dict.fail
        (
            key.name, "Entry '" + key.name + "' needs three numbers, such as (0 0 1)"
        );
    }
    return {given[0], given[1], given[2]};
}

CutPlane::CutPlane(const dictionary& dict)
:
    origin(read(dict, {"origin", "a point of the plane"}, {0, 0, 0})),
    normal(read(dict, {"normal", "across the plane"}, {0, 0, 1})),
    e1(read(dict, {"e1", "direction that becomes x"}, {1, 0, 0}))
{
    if (!(normal.norm() > 0))
    {
        dict.fail("normal", "The normal of a plane must not be zero");
    }
    normal.normalize();
    const scalar length = e1.norm();
    e1 -= e1.dot(normal)*normal;
    if (!(e1.norm() > 1e-6*length))
    {
        dict.fail
        (
            dict.found("e1") ? "e1" : "normal",
            "e1, which becomes x, must not be along the normal of the plane"
        );
    }
    e1.normalize();
}

} // namespace sph
