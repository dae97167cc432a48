#include "deposit/StartState.H"

#include "io/caseIO.H"
#include "runTime/Time.H"

namespace sph
{

std::unique_ptr<Particles> readFirstState
(
    const std::filesystem::path& caseDir, const word& presentTime
)
{
    for (const Time::Instant& time : Time::findTimes(caseDir))
    {
        if (time.name == presentTime)
        {
            return nullptr;
        }
        if (std::filesystem::exists(caseDir/time.name/"granular.vtp"))
        {
            auto particles = std::make_unique<Particles>();
            readState(caseDir/time.name, *particles);
            return particles;
        }
    }
    return nullptr;
}


StartPositions::StartPositions(const Particles& start)
{
    const auto [begin, end] = start.granular();
    positions_.reserve(end - begin);
    for (label i = begin; i < end; ++i)
    {
        positions_.emplace(start.id[i], start.r[i]);
    }
}


scalar StartPositions::mobilised
(
    const Particles& particles, const scalar distance
) const
{
    scalar known = 0, moved = 0;
    const auto [begin, end] = particles.granular();
    for (label i = begin; i < end; ++i)
    {
        const auto iter = positions_.find(particles.id[i]);
        if (iter != positions_.end())
        {
            known += particles.m[i];
            if ((particles.r[i] - iter->second).norm() > distance)
            {
                moved += particles.m[i];
            }
        }
    }
    return moved/known;
}

} // namespace sph
