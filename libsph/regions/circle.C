// A disc.
//
//     type circle;  centre (0.1 0.1 0);  radius 0.05;
//
// centre   [m]
// radius   [m]

#include "regions/Region.H"

#include <cmath>

namespace sph
{
namespace
{

class circle : public Region
{
    const vector centre_;
    const scalar radius_;

public:
    explicit circle(const dictionary& dict)
    :
        centre_
        (
            dict.getVector
            (
                {"centre", "centre of the disc", "(0.1 0.1 0)"}, dimLength
            )
        ),
        radius_
        (
            dict.get
            (
                {"radius", "radius of the disc", "0.05"},
                dimLength, Range::positive()
            )
        )
    {}

    bool inside(const vector& point) const override
    {
        return (point - centre_).squaredNorm() < radius_*radius_;
    }

    Bounds bounds() const override
    {
        return
        {
            centre_ - vector::Constant(radius_),
            centre_ + vector::Constant(radius_)
        };
    }

    scalar area() const override
    {
        return pi*radius_*radius_;
    }

    // |x + t d - c|^2 = R^2
    void crossings
    (
        const vector& origin, const vector& direction, std::vector<scalar>& t
    ) const override
    {
        const vector x = origin - centre_;
        const scalar a = direction.squaredNorm();
        const scalar b = direction.dot(x);
        const scalar discriminant =
            b*b - a*(x.squaredNorm() - radius_*radius_);
        if (discriminant > 0)
        {
            t.push_back((-b - std::sqrt(discriminant))/a);
            t.push_back((-b + std::sqrt(discriminant))/a);
        }
    }
};

static const Region::Add<circle> add("circle", "disc: centre, radius");

} // namespace
} // namespace sph
