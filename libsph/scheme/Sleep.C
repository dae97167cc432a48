#include "scheme/Sleep.H"

#include <algorithm>
#include <iostream>
#include <sstream>

namespace sph
{

Sleep::Sleep
(
    const dictionary& solution, const Ground& ground,
    Particles& particles, Neighbourhood& neighbourhood,
    const EquationOfState& eos, const scalar h
)
:
    particles_(particles),
    neighbourhood_(neighbourhood),
    eos_(eos),
    h_(h),
    magG_(ground.g.norm())
{
    const Key key("sleep", "particles at rest are not computed", "{}");
    if (!solution.found(key))
    {
        return;
    }
    if (!solution.isDict("sleep"))
    {
        solution.fail("sleep", "Entry 'sleep' must be a dictionary: sleep { }");
    }
    const dictionary& dict = solution.subDict("sleep");
    if (!(magG_ > 0))
    {
        solution.fail("sleep", "Without gravity nothing rests: no sleep");
    }
    read(dict);
    record_.emplace(ground, dict);
    particles.use("asleep");
    particles.use("Umean");
}

void Sleep::read(const dictionary& dict)
{
    const auto entry = [&](const Key& key, scalar value, scalar most)
    {
        return dict.getOrDefault
        (
            key, value, dimless, Range{0, most, false, true}
        );
    };
    speed_ = entry
    (
        {"speed", "what is faster flows; over sqrt(g H)"}, 0.02, 0.2
    );
    mean_ = entry({"mean", "what is faster in the mean flows"}, 0.01, 0.2);
    imbalance_ = entry
    (
        {"imbalance", "imbalance of stresses that wakes a sleeper"}, 0.08, 1
    );
    period_ = entry
    (
        {"period", "averaging time of the mean, over sqrt(H/g)"}, 0.1, 10
    );
    rest_ = entry
    (
        {"rest", "what is slower may fall asleep; at most speed"}, 0.002, 0.2
    );
    damping_ = dict.getOrDefault
    (
        {"damping", "time of the drag on the drowsy, over sqrt(H/g)"}, 0.05,
        dimless, Range::positive()
    );
    if (rest_ > speed_)
    {
        std::ostringstream os;
        os  << "Entry 'rest' is " << rest_ << " but must be at most speed, "
            << speed_;
        dict.fail(dict.found("rest") ? "rest" : "speed", os.str());
    }
}

void Sleep::start
(
    const std::filesystem::path& timeFolder, const bool restart
)
{
    if (record_)
    {
        std::cout << "Selecting sleep speed " << speed_*v() << " m/s mean "
            << mean_*v() << " m/s rest " << rest_*v() << " m/s\n";
    }
    Particles& P = particles_;
    const label n = P.granular().end;
    const std::string change =
        !record_ ? "no sleep in system/sphSolution"
      : restart ? record_->change(timeFolder)
      : "a new start";
    if (!change.empty())
    {
        const scalar* flags = P.asleep.data();
        const bool any = std::find(flags, flags + n, asleep) != flags + n;
        if ((restart && record_) || any)
        {
            std::cout << "All particles are awake: " << change << '\n';
        }
        std::fill_n(P.asleep.data(), n, awake);
        std::fill_n(P.Umean.x.data(), n, record_ ? 3*mean_*v() : 0);
        std::fill_n(P.Umean.y.data(), n, 0);
        P.setAwake(n, n);
        return;
    }
    // A state is written in the order of memory: those that are awake first
    label nAwake = 0;
    while (nAwake < n && P.asleep[nAwake] < asleep)
    {
        ++nAwake;
    }
    P.setAwake
    (
        nAwake, std::max(nAwake, SleepRecord::readActive(timeFolder))
    );
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

void Sleep::update(const scalar deltaT, const std::int64_t index)
{
    if (!record_)
    {
        return;
    }
    advanced_ += particles_.active().size();
    total_ += particles_.granular().size();
    average(deltaT);
    drag(deltaT);
    if (index % interval != 0)
    {
        return;
    }
    neighbourhood_.prepare();
    findMotion();
    const label falling = countFallingAsleep();
    setDrowsy();
    const label woken = wakeUp();
    if (woken > 0 || gains(falling))
    {
        fallAsleep();
        neighbourhood_.reset();
    }
}

void Sleep::write(const std::filesystem::path& timeFolder) const
{
    if (!record_)
    {
        SleepRecord::remove(timeFolder);
        return;
    }
    record_->write(timeFolder, particles_.active().end);
    std::cout << "Asleep: " << particles_.sleepers().size() << " of "
        << particles_.granular().size() << " particles\n";
}

void Sleep::printSummary() const
{
    if (record_ && total_ > 0)
    {
        std::cout << "Particle-steps made: "
            << 100*scalar(advanced_)/scalar(total_) << " %\n"
            << "Taken by sleep: momentum (" << momentum_.x() << ' '
            << momentum_.y() << ") kg/s, energy " << energy_ << " J/m\n\n";
    }
}

} // namespace sph
