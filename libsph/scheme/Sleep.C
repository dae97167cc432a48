#include "scheme/Sleep.H"

#include <cmath>
#include <iostream>

namespace sph
{

Sleep::Sleep
(
    const dictionary& solution, Particles& particles,
    Neighbourhood& neighbourhood, const EquationOfState& eos,
    const scalar h, const scalar magG, const bool restart
)
:
    particles_(particles),
    neighbourhood_(neighbourhood),
    eos_(eos),
    h_(h),
    magG_(magG),
    active_(solution.isDict("sleep"))
{
    if (active_)
    {
        const dictionary& dict = solution.subDict("sleep");
        if (!(magG > 0))
        {
            solution.fail("sleep", "Without gravity nothing rests: no sleep");
        }
        const auto entry = [&](const char* name, const scalar value)
        {
            return dict.getOrDefault(name, value, dimless, Range::positive());
        };
        speed_ = entry("speed", 0.02);
        mean_ = entry("mean", 0.01);
        imbalance_ = entry("imbalance", 0.08);
        period_ = entry("period", 0.1);
        rest_ = entry("rest", 0.002);
        damping_ = entry("damping", 0.05);
    }
    const label n = particles.granular().end;
    if (!active_ || !restart)
    {
        std::fill_n(particles.asleep.data(), n, awake);
        // Switched off: as if moving, for a restart that switches it on
        const scalar U = active_ ? 3*mean_*v() : v();
        std::fill_n(particles.Umean.x.data(), n, U);
        std::fill_n(particles.Umean.y.data(), n, 0);
    }
    // A state is written in the order of memory: those that are awake first
    label nAwake = 0;
    while (nAwake < n && particles.asleep[nAwake] < asleep)
    {
        ++nAwake;
    }
    particles.setAwake(nAwake, nAwake);
}

void Sleep::average(const scalar deltaT)
{
    const scalar f = deltaT/tau();
    const auto follow = [&](const ParticleRange& range, const vectorField& to)
    {
        const scalar gain = &to == &particles_.U ? f : deltaT;
        scalar* mx = particles_.Umean.x.data();
        scalar* my = particles_.Umean.y.data();
        const scalar* x = to.x.data();
        const scalar* y = to.y.data();
        #pragma omp simd
        for (label i = range.begin; i < range.end; ++i)
        {
            mx[i] += gain*x[i] - f*mx[i];
            my[i] += gain*y[i] - f*my[i];
        }
    };
    follow(particles_.awake(), particles_.U);
    follow(particles_.watching(), particles_.a);

    for (label i = particles_.awake().end; i < particles_.active().end; ++i)
    {
        momentum_ += deltaT*particles_.m[i]*particles_.a[i];
    }
}

// a -= U g/(damping v) of those that are drowsy
void Sleep::drag(const scalar deltaT)
{
    Particles& P = particles_;
    const scalar f = std::min(deltaT*magG_/(damping_*v()), 1.0);
    for (label i = 0; i < P.awake().end; ++i)
    {
        if (P.asleep[i] == drowsy)
        {
            const vector U = P.U[i];
            momentum_ += f*P.m[i]*U;
            energy_ += 0.5*P.m[i]*(1 - (1 - f)*(1 - f))*U.squaredNorm();
            P.U.set(i, (1 - f)*U);
        }
    }
}

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

void Sleep::update(const scalar deltaT)
{
    if (!active_)
    {
        return;
    }
    advanced_ += particles_.active().size();
    total_ += particles_.granular().size();
    average(deltaT);
    drag(deltaT);
    if (++steps_ % interval != 0)
    {
        return;
    }
    findMotion();
    const label falling = countFallingAsleep();
    setDrowsy();
    const label woken = wakeUp();
    if (woken > 0 || falling > worthwhile*particles_.awake().size())
    {
        fallAsleep();
        neighbourhood_.reset();
        std::cout << "Sleep: " << falling << " fall asleep, " << woken
            << " wake; asleep before: " << particles_.sleepers().size()
            << " of " << particles_.granular().size()
            << "; particle-steps made: " << 100*advanced_/total_
            << " %; taken: momentum (" << momentum_.x() << ' '
            << momentum_.y() << ") energy " << energy_ << '\n';
    }
}

} // namespace sph
