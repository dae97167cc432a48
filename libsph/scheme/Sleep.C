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
    }
    const label n = particles.granular().end;
    if (!active_ || !restart)
    {
        std::fill_n(particles.asleep.data(), n, 0);
        std::fill_n(particles.Umean.x.data(), n, 3*mean_*v());
        std::fill_n(particles.Umean.y.data(), n, 0);
    }
    // A state is written in the order of memory: those that are awake first
    label nAwake = 0;
    while (nAwake < n && !particles.asleep[nAwake])
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

// Cells in which particles move, and in which they move enough to wake others;
// and the cells around them
void Sleep::findMotion()
{
    const CellGrid& grid = neighbourhood_.grid();
    const labelField& cells = grid.cells();
    moving_.assign(std::size_t(grid.nx())*grid.ny(), false);
    rousing_ = moving_;
    const Particles& P = particles_;
    const scalar imbalance = imbalance_*tau()*v()*v()/h_;
    const auto ratioSqr = [](const vectorField& U, label i, scalar limit)
    {
        return (U.x[i]*U.x[i] + U.y[i]*U.y[i])/(limit*limit);
    };
    for (label i = 0; i < P.awake().end; ++i)
    {
        const scalar motionSqr = std::max
        (
            ratioSqr(P.U, i, speed_*v()), ratioSqr(P.Umean, i, mean_*v())
        );
        moving_[cells[i]] |= motionSqr > 1;
        rousing_[cells[i]] |= motionSqr > 4;
    }
    for (label i = P.awake().end; i < P.active().end; ++i)
    {
        const bool pushed = ratioSqr(P.Umean, i, imbalance) > 1;
        moving_[cells[i]] |= pushed;
        rousing_[cells[i]] |= pushed;
    }
    grid.dilate(moving_);
    grid.dilate(rousing_);
}

label Sleep::countFallingAsleep() const
{
    const labelField& cells = neighbourhood_.grid().cells();
    label count = 0;
    for (label i = 0; i < particles_.awake().end; ++i)
    {
        count += !moving_[cells[i]];
    }
    return count;
}

label Sleep::wakeUp()
{
    const labelField& cells = neighbourhood_.grid().cells();
    label count = 0;
    for (label i = particles_.awake().end; i < particles_.granular().end; ++i)
    {
        if (rousing_[cells[i]])
        {
            particles_.asleep[i] = 0;
            // Not to fall asleep again at once, nor to wake others
            particles_.Umean.set(i, {1.9*mean_*v(), 0});
            ++count;
        }
    }
    return count;
}

void Sleep::fallAsleep()
{
    const labelField& cells = neighbourhood_.grid().cells();
    Particles& P = particles_;
    const vector zero = vector::Zero();
    for (label i = 0; i < P.awake().end; ++i)
    {
        if (!moving_[cells[i]])
        {
            momentum_ += P.m[i]*P.U[i];
            energy_ += 0.5*P.m[i]*P.U[i].squaredNorm();
            P.asleep[i] = 1;
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
    average(deltaT);
    if (++steps_ % interval != 0)
    {
        return;
    }
    findMotion();
    const label falling = countFallingAsleep();
    const label woken = wakeUp();
    if (woken > 0 || falling > worthwhile*particles_.awake().size())
    {
        fallAsleep();
        neighbourhood_.reset();
        std::cout << "Sleep: " << falling << " fall asleep, " << woken
            << " wake; awake before: " << particles_.awake().size() << " of "
            << particles_.granular().size() << "; momentum taken: ("
            << momentum_.x() << ' ' << momentum_.y() << ") energy taken: "
            << energy_ << '\n';
    }
}

} // namespace sph
