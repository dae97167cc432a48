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
        const dictionary&, PairWalk&, const EquationOfState&, const Kernel&
    )
    {}

    bool hasPairTerm() const override { return false; }

    void evaluate(const PairBlock&) override {}

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
