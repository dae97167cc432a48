// div(s), s = 2 eta D with the corrected velocity gradient: the form for every
// elastic law, and the consistent one where eta varies.
//
//     viscousScheme  stressDivergence;

#include "viscousSchemes/ViscousScheme.H"

namespace sph
{
namespace
{

class stressDivergence : public ViscousScheme
{
public:
    stressDivergence(const dictionary&, const Particles&)
    {}

    bool stressCarriesShear() const override { return true; }
};

static const ViscousScheme::Add<stressDivergence> add
(
    "stressDivergence", "divergence of the stress 2 eta D, or of an elastic one"
);

} // namespace
} // namespace sph
