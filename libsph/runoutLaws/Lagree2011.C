// Continuum simulations with mu(I), two-dimensional: no side walls, so that
// columns run farther than in channels.
//
//     (Lf - L0)/L0 = 2.2 a  (a < 7),    3.9 a^0.7   (a > 7)
//     Hf/L0        = 0.65 a^0.35  (a > 1)
//
// Lagree, Staron & Popinet, J. Fluid Mech. 686, 378 (2011). Friction of glass
// beads, mu_s about 0.32. Fits without a published scatter.
//
//     law  Lagree2011;

#include "runoutLaws/RunoutLaw.H"

#include <limits>

namespace sph
{
namespace
{

class Lagree2011 : public RunoutLaw
{
    static constexpr scalar unknown =
        std::numeric_limits<scalar>::quiet_NaN();

public:
    explicit Lagree2011(const dictionary& dict)
    :
        RunoutLaw(dict)
    {}

    LawValue runout(const scalar a) const override
    {
        return evaluate
        (
            {{2.2, 1, 0, 7, unknown}, {3.9, 0.7, 7, 70, unknown}}, a
        );
    }

    LawValue height(const scalar a) const override
    {
        return evaluate({{0.65, 0.35, 1, 70, unknown}}, a);
    }

    LawValue stopTime(scalar) const override
    {
        return LawValue::none("no law");
    }
};

static const RunoutLaw::Add<Lagree2011> add
(
    "Lagree2011", "fits to 2D mu(I) continuum simulations"
);

} // namespace
} // namespace sph
