// Sand, sugar and rice between plates, a channel of smooth walls.
//
//     (Lf - L0)/L0 = 1.2 a  (a < 1.8),    1.9 a^(2/3)  (a > 2.8)         (51)
//     Hf/L0        = a      (a < 1.15),   a^0.4        (a > 1.15)        (52)
//     t            = 3.2 sqrt(H0/g)                                      (53)
//
// Lube, Huppert, Sparks & Freundt, Phys. Rev. E 72, 041301 (2005); equation
// numbers: Salehizadeh & Shafiei, Granular Matter 21:32 (2019). The scatter of
// the data was not published as a number: the band is the case's to set.
//
//     law  Lube2005;

#include "runoutLaws/RunoutLaw.H"

#include <limits>

namespace sph
{
namespace
{

class Lube2005 : public RunoutLaw
{
    static constexpr scalar unknown =
        std::numeric_limits<scalar>::quiet_NaN();

public:
    explicit Lube2005(const dictionary& dict)
    :
        RunoutLaw(dict)
    {}

    LawValue runout(const scalar a) const override
    {
        return evaluate
        (
            {{1.2, 1, 0, 1.8, unknown}, {1.9, 2.0/3, 2.8, 20, unknown}}, a
        );
    }

    LawValue height(const scalar a) const override
    {
        return evaluate
        (
            {{1, 1, 0, 1.15, unknown}, {1, 0.4, 1.15, 20, unknown}}, a
        );
    }

    LawValue stopTime(scalar) const override
    {
        return {3.2, unknown, "the front"};
    }
};

static const RunoutLaw::Add<Lube2005> add
(
    "Lube2005", "2D columns of sand, sugar and rice, Eq. 51-53"
);

} // namespace
} // namespace sph
