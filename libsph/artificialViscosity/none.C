// No numerical dissipation.
//
//     artificialViscosity  none;

#include "artificialViscosity/ArtificialViscosity.H"

namespace sph
{
namespace
{

class noArtificialViscosity : public ArtificialViscosity
{
public:
    noArtificialViscosity
    (
        const dictionary&, const EquationOfState&, const Kernel&
    )
    {}

    void bulkPressure
    (
        Particles& particles, const ParticleRange& range
    ) const override
    {
        noBulkPressure(particles, range);
    }
};

static const ArtificialViscosity::Add<noArtificialViscosity> add
(
    "none", "no numerical dissipation"
);

} // namespace
} // namespace sph
