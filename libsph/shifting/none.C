// Particles move with their velocity.
//
//     shifting  none;

#include "shifting/Shifting.H"

namespace sph
{
namespace
{

class noShifting : public Shifting
{
public:
    noShifting(const dictionary&, PairWalk&, const Kernel&)
    {}

    bool hasPairTerm() const override { return false; }
    void evaluate(const PairBlock&) override {}
};

static const Shifting::Add<noShifting> add
(
    "none", "particles move with their velocity"
);

} // namespace
} // namespace sph
