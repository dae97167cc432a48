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
    noShifting(const dictionary&, const Particles&, const Kernel&)
    {}
};

static const Shifting::Add<noShifting> add
(
    "none", "particles move with their velocity"
);

} // namespace
} // namespace sph
