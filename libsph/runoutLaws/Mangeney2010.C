// Glass beads in a rough channel, released by a gate, on a horizontal plane.
//
//     (Lf - L0)/L0 = 2 k a/tan(delta)
//     Hf/L0        = beta a (tan(delta)/(k a))^(2/3)
//
// Mangeney et al., J. Geophys. Res. 115, F03040 (2010), Eqs. 5-6: delta is
// the angle of avalanche of the beads. No scatter is published with them, and
// nothing for planes that are inclined: theta [deg] other than 0 has no law.
//
//     law  Mangeney2010;
//     Mangeney2010Coeffs { k 0.5; delta 25.5; beta 0.76; theta 0; }

#include "runoutLaws/RunoutLaw.H"

#include <cmath>
#include <limits>

namespace sph
{
namespace
{

class Mangeney2010 : public RunoutLaw
{
    static constexpr scalar unknown =
        std::numeric_limits<scalar>::quiet_NaN();

    const scalar k_;
    const scalar tanDelta_;
    const scalar beta_;
    const bool horizontal_;

    static scalar degrees
    (
        const dictionary& dict, const Key& entry, const scalar value,
        const Range& range
    )
    {
        return dict.getOrDefault(entry, value, dimless, range);
    }

public:
    explicit Mangeney2010(const dictionary& dict)
    :
        RunoutLaw(dict),
        k_
        (
            dict.getOrDefault
            (
                {"k", "factor of the run-out"}, 0.5, dimless, Range::positive()
            )
        ),
        tanDelta_
        (
            std::tan
            (
                M_PI/180*degrees
                (
                    dict, {"delta", "angle of avalanche [deg]"}, 25.5,
                    Range::between(1, 60)
                )
            )
        ),
        beta_
        (
            dict.getOrDefault
            (
                {"beta", "factor of the height"}, 0.76,
                dimless, Range::positive()
            )
        ),
        horizontal_
        (
            degrees
            (
                dict, {"theta", "slope of the bed [deg]: a law for 0 only"},
                0, Range::any()
            )
         == 0
        )
    {}

    LawValue runout(const scalar a) const override
    {
        return horizontal_ ? LawValue{2*k_*a/tanDelta_, unknown, ""} : none();
    }

    LawValue height(const scalar a) const override
    {
        return
            horizontal_
          ? LawValue
            {
                beta_*a*std::pow(tanDelta_/(k_*a), 2.0/3), unknown, ""
            }
          : none();
    }

    LawValue stopTime(scalar) const override
    {
        return LawValue::none("no law");
    }

private:
    static LawValue none()
    {
        return LawValue::none("no law for inclined planes");
    }
};

static const RunoutLaw::Add<Mangeney2010> add
(
    "Mangeney2010", "glass beads from a gate, horizontal plane"
);

} // namespace
} // namespace sph
