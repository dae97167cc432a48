// A rectangle in any direction; the lattice is laid along its sides.
//
//     type rotatedBox;  origin (0 0 0);  i (0.1 0.05 0);  j (-0.1 0.2 0);
//
// origin   one corner [m]
// i, j     the two sides that meet there, at right angles [m]

#include "regions/Outline.H"

#include <cmath>

namespace sph
{
namespace
{

class rotatedBox : public Outline
{
    static std::vector<vector> corners(const dictionary& dict)
    {
        const vector origin = dict.getVector
        (
            {"origin", "one corner", "(0.1 0 0)"}, dimLength
        );
        const vector i = dict.getVector
        (
            {"i", "one side from there", "(0.1 0.05 0)"}, dimLength
        );
        const vector j = dict.getVector
        (
            {"j", "the other, at right angles", "(-0.05 0.1 0)"}, dimLength
        );
        if (!(i.norm() > 0))
        {
            dict.fail("i", "The side i has no length");
        }
        if (!(j.norm() > 0))
        {
            dict.fail("j", "The side j has no length");
        }
        if (std::abs(i.dot(j)) > 1e-6*i.norm()*j.norm())
        {
            dict.fail
            (
                "j",
                "The sides i and j are not at right angles;"
                " use a polygon for an oblique shape"
            );
        }
        return {origin, origin + i, origin + i + j, origin + j};
    }

public:
    explicit rotatedBox(const dictionary& dict)
    :
        Outline(corners(dict))
    {}

    Frame frame() const override
    {
        const vector& origin = points()[0];
        tensor axes;
        axes.col(0) = (points()[1] - origin).normalized();
        axes.col(1) = (points()[3] - origin).normalized();
        return {origin, axes};
    }
};

static const Region::Add<rotatedBox> add
(
    "rotatedBox", "rectangle in any direction: origin, i, j"
);

} // namespace
} // namespace sph
