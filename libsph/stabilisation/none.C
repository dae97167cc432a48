// No density diffusion.
//
//     stabilisation  none;

#include "stabilisation/Stabilisation.H"

namespace sph
{
namespace
{

class noStabilisation : public Stabilisation
{
public:
    noStabilisation(const dictionary&, const EquationOfState&, const Kernel&)
    {}
};

static const Stabilisation::Add<noStabilisation> add
(
    "none", "no density diffusion"
);

} // namespace
} // namespace sph
