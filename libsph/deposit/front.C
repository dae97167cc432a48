#include "deposit/front.H"

#include <limits>

namespace sph
{

// step: -1 to the left, 1 to the right
static scalar front
(
    const Profile& profile, const scalar threshold, const label step
)
{
    label bin = profile.thickest();
    while (profile.h(bin + step) >= threshold)
    {
        bin += step;
    }
    const scalar inner = profile.h(bin), outer = profile.h(bin + step);
    return
        profile.x(bin)
      + step*profile.binWidth()*(inner - threshold)/(inner - outer);
}


Fronts fronts(const Profile& profile, const scalar threshold)
{
    if (profile.h(profile.thickest()) < threshold)
    {
        const scalar none = std::numeric_limits<scalar>::quiet_NaN();
        return {none, none};
    }
    return {front(profile, threshold, -1), front(profile, threshold, 1)};
}

} // namespace sph
