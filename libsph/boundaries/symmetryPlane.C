// Mirror: every particle near the plane has an image behind it.
//
//     axis { type symmetryPlane; point (0 0 0); normal (1 0 0); }
//
// The normal points into the material.

#include "boundaries/Boundary.H"

namespace sph
{
namespace
{

class symmetryPlane : public Boundary
{
    const vector point_;
    const vector normal_;

    static vector unitNormal(const dictionary& dict)
    {
        const vector n = dict.getVector
        (
            {"normal", "normal into the material", "(1 0 0)"}, dimless
        );
        if (!(n.norm() > 0))
        {
            dict.fail("normal", "The normal of a plane must not be zero");
        }
        return n.normalized();
    }

public:
    symmetryPlane
    (
        const dictionary& dict, const word& name, const scalar spacing
    )
    :
        Boundary(name, spacing),
        point_
        (
            dict.getVector
            (
                {"point", "a point of the plane", "(0 0 0)"}, dimLength
            )
        ),
        normal_(unitNormal(dict))
    {}

    scalar distance(const vector& point) const override
    {
        return (point - point_).dot(normal_);
    }

    tensor reflection() const override
    {
        return tensor::Identity() - 2*normal_*normal_.transpose();
    }

    void makeImages
    (
        const vectorField& r, const label begin, const label end,
        const scalar reach, std::vector<Image>& images
    ) const override
    {
        const vector shift = 2*point_.dot(normal_)*normal_;
        for (label i = begin; i < end; ++i)
        {
            if (std::abs(distance(r[i])) < reach)
            {
                images.push_back({i, -1, shift});
            }
        }
    }

    label net
    (
        Particles& particles, const ParticleRange& range
    ) const override
    {
        label hits = 0;
        for (label i = range.begin; i < range.end; ++i)
        {
            const scalar d =
                (particles.r.x[i] - point_.x())*normal_.x()
              + (particles.r.y[i] - point_.y())*normal_.y();
            if (d < 0)
            {
                particles.r.set(i, particles.r[i] - 2*d*normal_);
                const scalar Un = particles.U[i].dot(normal_);
                particles.U.set
                (
                    i, particles.U[i] + 2*std::max(-Un, 0.0)*normal_
                );
                ++hits;
            }
        }
        return hits;
    }
};

static const Boundary::Add<symmetryPlane> add
(
    "symmetryPlane", "mirror plane"
);

} // namespace
} // namespace sph
