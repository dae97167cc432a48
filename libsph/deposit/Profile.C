#include "deposit/Profile.H"

#include "primitives/error.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sph
{

// More bins than this hold no deposit but a particle that has run away
static constexpr scalar maxBins = 1e7;


Profile::Profile
(
    const scalar begin, const scalar binWidth, std::vector<scalar> thickness
)
:
    begin_(begin),
    binWidth_(binWidth),
    thickness_(std::move(thickness))
{}


Profile::Profile
(
    const Particles& particles, const BedLine& bed,
    const scalar rho0, const scalar binWidth
)
:
    binWidth_(binWidth)
{
    const label n = particles.granular().size();
    if (n == 0)
    {
        throw Error("No granular particles: there is no surface profile");
    }

    scalar xMin = std::numeric_limits<scalar>::max(), xMax = -xMin;
    std::vector<scalar> x(n), width(n);
    for (label i = 0; i < n; ++i)
    {
        x[i] = bed.x(particles.r[i]);
        width[i] = std::sqrt(particles.m[i]/rho0);
        if (!std::isfinite(x[i] + width[i]))
        {
            throw Error
            (
                "The place or the mass of particle "
              + std::to_string(particles.id[i]) + " is not a finite number:"
                " there is no surface profile"
            );
        }
        xMin = std::min(xMin, x[i] - 0.5*width[i]);
        xMax = std::max(xMax, x[i] + 0.5*width[i]);
    }

    // One bin to spare on each side: sums then round within the profile
    const scalar first = std::floor(xMin/binWidth) - 1;
    const scalar last = std::floor(xMax/binWidth) + 1;
    if (!(last - first < maxBins))
    {
        throw Error
        (
            "The particles reach from x = " + std::to_string(xMin) + " m to "
          + std::to_string(xMax) + " m: too far for a surface profile"
        );
    }
    begin_ = first*binWidth;
    thickness_.assign(std::size_t(last - first) + 1, 0);

    for (label i = 0; i < n; ++i)
    {
        const scalar left = (x[i] - 0.5*width[i])/binWidth - first;
        const scalar right = (x[i] + 0.5*width[i])/binWidth - first;
        const scalar h = width[i]*width[i]/((right - left)*binWidth);
        for (label k = label(left); k <= label(right); ++k)
        {
            const scalar covered =
                std::min(right, k + 1.0) - std::max(left, scalar(k));
            thickness_[k] += h*covered;
        }
    }
}


label Profile::bin(const scalar x) const
{
    return label(std::floor((x - begin_)/binWidth_));
}


label Profile::thickest() const
{
    return label
    (
        std::max_element(thickness_.begin(), thickness_.end())
      - thickness_.begin()
    );
}


Profile Profile::movingMean(const label n) const
{
    std::vector<scalar> mean(size() + n - 1, 0);
    for (label i = 0; i < size(); ++i)
    {
        for (label k = i; k < i + n; ++k)
        {
            mean[k] += thickness_[i]/n;
        }
    }
    return {begin_ - 0.5*(n - 1)*binWidth_, binWidth_, std::move(mean)};
}


scalar Profile::volume() const
{
    return
        binWidth_*std::accumulate(thickness_.begin(), thickness_.end(), 0.0);
}

} // namespace sph
