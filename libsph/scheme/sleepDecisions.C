// Who moves, who falls asleep and who wakes.
#include "scheme/Sleep.H"

#include <algorithm>

namespace sph
{

// Which particles move, and which move enough to wake others: flags of their
// cells and those around. Images move as their sources do.
void Sleep::findMotion()
{
    const Particles& P = particles_;
    const scalar imbalance = imbalance_*tau()*v()*v()/h_;
    const auto ratioSqr = [](const vectorField& U, label i, scalar limit)
    {
        return (U.x[i]*U.x[i] + U.y[i]*U.y[i])/(limit*limit);
    };
    motion_.assign(P.size(), 0);
    for (label i = 0; i < P.awake().end; ++i)
    {
        const scalar ratio = std::max
        (
            ratioSqr(P.U, i, speed_*v()), ratioSqr(P.Umean, i, mean_*v())
        );
        const bool stirs =
            P.asleep[i] != drowsy || ratioSqr(P.U, i, rest_*v()) > 1;
        motion_[i] =
            ratio > 4 ? stirring | moving | rousing
          : ratio > 1 ? stirring | moving
          : stirs ? stirring
          : 0;
    }
    for (label i = P.awake().end; i < P.active().end; ++i)
    {
        const bool pushed = ratioSqr(P.Umean, i, imbalance) > 1;
        motion_[i] = pushed ? stirring | moving | rousing : 0;
    }
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        const bool moves = P.Umean.x[w] != 0 || P.Umean.y[w] != 0;
        motion_[w] = moves ? stirring | moving | rousing : 0;
    }
    const auto& images = neighbourhood_.images();
    for (std::size_t k = 0; k < images.size(); ++k)
    {
        motion_[P.ghosts().begin + label(k)] = motion_[images[k].source];
    }

    const CellGrid& grid = neighbourhood_.grid();
    cellMotion_.assign(std::size_t(grid.nx())*grid.ny(), 0);
    label k = 0;
    for (const ParticleRange& range : {P.granular(), P.walls(), P.ghosts()})
    {
        for (label i = range.begin; i < range.end; ++i, ++k)
        {
            cellMotion_[grid.cells()[k]] |= motion_[i];
        }
    }
    grid.dilate(cellMotion_);
}

label Sleep::countFallingAsleep() const
{
    const labelField& cells = neighbourhood_.grid().cells();
    label count = 0;
    for (label i = 0; i < particles_.awake().end; ++i)
    {
        count += !(cellMotion_[cells[i]] & stirring);
    }
    return count;
}

label Sleep::wakeUp()
{
    const labelField& cells = neighbourhood_.grid().cells();
    label count = 0;
    for (label i = particles_.awake().end; i < particles_.granular().end; ++i)
    {
        if (cellMotion_[cells[i]] & rousing)
        {
            particles_.asleep[i] = awake;
            // Not to grow drowsy again at once, nor to wake others
            particles_.Umean.set(i, {1.9*mean_*v(), 0});
            ++count;
        }
    }
    return count;
}

void Sleep::setDrowsy()
{
    const labelField& cells = neighbourhood_.grid().cells();
    for (label i = 0; i < particles_.awake().end; ++i)
    {
        particles_.asleep[i] = cellMotion_[cells[i]] & moving ? awake : drowsy;
    }
}

void Sleep::fallAsleep()
{
    const labelField& cells = neighbourhood_.grid().cells();
    Particles& P = particles_;
    const vector zero = vector::Zero();
    for (label i = 0; i < P.awake().end; ++i)
    {
        if (!(cellMotion_[cells[i]] & stirring))
        {
            momentum_ += P.m[i]*P.U[i];
            energy_ += 0.5*P.m[i]*P.U[i].squaredNorm();
            P.asleep[i] = asleep;
            P.U.set(i, zero);
            P.Us.set(i, zero);
            P.a.set(i, zero);
            P.Umean.set(i, zero);
            P.rhoDot[i] = 0;
        }
    }
}

bool Sleep::gains(const label falling) const
{
    const label n = particles_.awake().size();
    const label gained = roundUpToLanes(n) - roundUpToLanes(n - falling);
    return gained > worthwhile*n;
}

} // namespace sph
