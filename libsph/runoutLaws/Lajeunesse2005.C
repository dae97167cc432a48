// Glass beads of 1.15 mm in a channel.
//
//     (Lf - L0)/L0 = 1.8 a  (a < 3),      2.5 a^(2/3)   (a > 3)
//     Hf/L0        = a      (a < 0.7),    0.9 a^(1/3)   (a > 0.85)
//     t            = (0.8 + 2 + 0.6) sqrt(H0/g)
//
// Lajeunesse, Monnier & Homsy, Phys. Fluids 17, 103302 (2005). The lines as
// drawn in their figure, digitised; the text quotes 2.3 for the 2.5. Bands:
// scatter of the digitised points, 12 % and 14 % of the run-out and 5 % of
// the height.
//
//     law  Lajeunesse2005;

#include "runoutLaws/RunoutLaw.H"

#include <limits>

namespace sph
{
namespace
{

class Lajeunesse2005 : public RunoutLaw
{
public:
    explicit Lajeunesse2005(const dictionary& dict)
    :
        RunoutLaw(dict)
    {}

    LawValue runout(const scalar a) const override
    {
        return evaluate
        (
            {{1.8, 1, 0, 3, 0.12}, {2.5, 2.0/3, 3, 22, 0.14}}, a
        );
    }

    LawValue height(const scalar a) const override
    {
        return evaluate
        (
            {{1, 1, 0, 0.7, 0.05}, {0.9, 1.0/3, 0.85, 30, 0.05}}, a
        );
    }

    LawValue stopTime(scalar) const override
    {
        return
        {
            3.4, std::numeric_limits<scalar>::quiet_NaN(),
            "the front: 0.8 + 2 + 0.6"
        };
    }
};

static const RunoutLaw::Add<Lajeunesse2005> add
(
    "Lajeunesse2005", "glass beads in a channel, bands from the scatter"
);

} // namespace
} // namespace sph
