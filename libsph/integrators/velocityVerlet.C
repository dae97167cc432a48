// Kick, drift, kick: second order in time.
//
//     U' = U + dt/2 a(t),   r += dt U',   U = U' + dt/2 a(t + dt)
//
// The rates of density and stress over the step take the velocity in its
// middle, U'.
//
//     integrator  velocityVerlet;

#include "integrators/Integrator.H"

namespace sph
{
namespace
{

class velocityVerlet : public Integrator
{
public:
    explicit velocityVerlet(const dictionary&)
    {}

    void begin(Particles& particles, const scalar deltaT) override
    {
        kickAndDrift(particles, 0.5*deltaT, deltaT);
    }

    void end(Particles& particles, const scalar deltaT) override
    {
        kick(particles, 0.5*deltaT);
    }
};

static const Integrator::Add<velocityVerlet> add
(
    "velocityVerlet", "kick, drift, kick: second order in time"
);

} // namespace
} // namespace sph
