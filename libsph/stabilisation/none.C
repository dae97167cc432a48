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
    noStabilisation
    (
        const dictionary&, PairWalk&, const EquationOfState&, const Kernel&
    )
    {}

    bool hasPairTerm() const override { return false; }
    bool needsGradRho() const override { return false; }
    void evaluate(const PairBlock&) override {}
};

static const Stabilisation::Add<noStabilisation> add
(
    "none", "no density diffusion"
);

} // namespace
} // namespace sph
