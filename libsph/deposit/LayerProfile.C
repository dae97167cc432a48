#include "deposit/LayerProfile.H"

#include <cmath>
#include <map>

namespace sph
{

LayerProfile::LayerProfile
(
    const Particles& particles,
    const std::vector<const scalarField*>& components,
    const vector& origin, const vector& direction, const scalar width
)
{
    std::map<std::int64_t, Bin> bins;
    const auto [begin, end] = particles.granular();
    for (label i = begin; i < end; ++i)
    {
        const scalar z = (particles.r[i] - origin).dot(direction);
        const scalar V = particles.m[i]/particles.rho[i];
        const auto added = bins.emplace
        (
            std::int64_t(std::floor(z/width)),
            Bin{0, 0, std::vector<scalar>(components.size(), 0)}
        );
        Bin& bin = added.first->second;
        bin.z += V*z;
        bin.volume += V;
        for (std::size_t c = 0; c < components.size(); ++c)
        {
            bin.values[c] += V*(*components[c])[i];
        }
    }
    for (auto& [index, bin] : bins)
    {
        bin.z /= bin.volume;
        for (scalar& value : bin.values)
        {
            value /= bin.volume;
        }
        bins_.push_back(std::move(bin));
    }
}

} // namespace sph
