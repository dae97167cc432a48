// Smooth side walls, or none.
//
//     sideWalls  none;        // default

#include "sideWalls/SideWalls.H"

namespace sph
{
namespace
{

class none : public SideWalls
{
public:
    explicit none(const dictionary&)
    {}

    bool any() const override { return false; }

    void addDrag(Particles&, const ParticleRange&, scalar) const override {}
};

static const SideWalls::Add<none> add
(
    "none", "no friction in front and behind"
);

} // namespace
} // namespace sph
