// Velocity first, position with the new velocity.
//
//     U += dt a(t),   r += dt U
//
//     integrator  symplecticEuler;

#include "integrators/Integrator.H"

namespace sph
{
namespace
{

class symplecticEuler : public Integrator
{
public:
    explicit symplecticEuler(const dictionary&)
    {}

    void begin(Particles& particles, const scalar deltaT) override
    {
        kickAndDrift(particles, deltaT, deltaT);
    }

    void end(Particles&, scalar) override {}
};

static const Integrator::Add<symplecticEuler> add
(
    "symplecticEuler", "U += dt a, r += dt U: one force evaluation a step"
);

} // namespace
} // namespace sph
