// Two planes that the material leaves through and enters by: what goes out at
// one comes in at the other.
//
//     ends { type periodic; point (0 0 0); translation (0.1 0 0); }
//
// The planes stand at point and at point + translation, normal to translation.

#include "boundaries/Boundary.H"

namespace sph
{
namespace
{

class periodic : public Boundary
{
    const vector point_;
    const vector translation_;
    const scalar length_;
    const vector direction_;

    static vector nonZero(const dictionary& dict)
    {
        const vector t = dict.getVector
        (
            {"translation", "way from it to the other plane", "(0.4 0 0)"},
            dimLength
        );
        if (!(t.norm() > 0))
        {
            dict.fail("translation", "The translation must not be zero");
        }
        return t;
    }

public:
    periodic(const dictionary& dict, const word& name, const scalar spacing)
    :
        Boundary(name, spacing),
        point_
        (
            dict.getVector
            (
                {"point", "a point of the first plane", "(0 0 0)"}, dimLength
            )
        ),
        translation_(nonZero(dict)),
        length_(translation_.norm()),
        direction_(translation_/length_)
    {}

    scalar distance(const vector&) const override
    {
        return std::numeric_limits<scalar>::infinity();
    }

    void makeImages
    (
        const vectorField& r, const label begin, const label end,
        const scalar reach, std::vector<Image>& images
    ) const override
    {
        for (label i = begin; i < end; ++i)
        {
            const scalar along = (r[i] - point_).dot(direction_);
            if (along < reach)
            {
                images.push_back({i, -1, translation_});
            }
            if (along > length_ - reach)
            {
                images.push_back({i, -1, -translation_});
            }
        }
    }

    void check(const Particles& particles, const scalar reach) const override
    {
        if (length_ < 2*reach)
        {
            throw Error
            (
                "The periodic patch " + name() + " is "
              + std::to_string(length_) + " m long, but particles must not"
                " see their own images: at least " + std::to_string(2*reach)
              + " m, or smaller particles"
            );
        }
        for (label i = 0; i < particles.granular().end; ++i)
        {
            const scalar along = (particles.r[i] - point_).dot(direction_);
            if (along < -reach || along > length_ + reach)
            {
                throw Error
                (
                    "Particle " + std::to_string(particles.id[i])
                  + " starts outside the planes of the periodic patch "
                  + name()
                );
            }
        }
    }

    void wrap(Particles& particles) const override
    {
        for (label i = 0; i < particles.awake().end; ++i)
        {
            const scalar along = (particles.r[i] - point_).dot(direction_);
            if (along < 0)
            {
                particles.r.set(i, particles.r[i] + translation_);
            }
            else if (along >= length_)
            {
                particles.r.set(i, particles.r[i] - translation_);
            }
        }
    }
};

static const Boundary::Add<periodic> add
(
    "periodic", "what leaves at one plane enters at the other"
);

} // namespace
} // namespace sph
