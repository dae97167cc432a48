// No sub-particle-scale stress.
//
//     turbulence  laminar;

#include "turbulence/Turbulence.H"

namespace sph
{
namespace
{

class laminar : public Turbulence
{
public:
    laminar(const dictionary&, scalar)
    {}

    void addStress(Particles&, const ParticleRange&) const override {}
    bool any() const override { return false; }
};

static const Turbulence::Add<laminar> add
(
    "laminar", "no sub-particle-scale stress"
);

} // namespace
} // namespace sph
