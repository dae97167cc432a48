#include "scheme/SoundSpeed.H"

#include "primitives/writeFile.H"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>

namespace sph
{

// Ratio of two values of K, one after the other
static constexpr scalar rung = 1.1;

// At the end of a window: to half of K
static constexpr label mostRungsDown = 7;

SoundSpeed::SoundSpeed
(
    EquationOfState& eos, const vector& g, Particles& particles,
    const scalar time
)
:
    eos_(eos),
    particles_(particles),
    g_(g),
    minK_(eos.KFactor()*eos.rho0()*g.norm()*4*particles.spacing()),
    maxK_(100*eos.K())
{
    openWindow(time);
}

scalar SoundSpeed::K(const label rungs) const
{
    return eos_.K()*std::pow(rung, rungs);
}

void SoundSpeed::openWindow(const scalar time)
{
    windowStart_ = time;
    windowRungs_ = 0;
    while
    (
        windowRungs_ > -mostRungsDown && K(windowRungs_ - 1) >= minK_
    )
    {
        --windowRungs_;
    }
}

// Hs = c^2/(KFactor |g|)
scalar SoundSpeed::windowLength() const
{
    return 4*eos_.c()/(eos_.KFactor()*g_.norm());
}

bool SoundSpeed::follow(const scalar time)
{
    if (!eos_.adaptive())
    {
        return false;
    }
    while
    (
        K(windowRungs_) < maxK_
     && exceeds(K(windowRungs_)/eos_.KFactor())
    )
    {
        ++windowRungs_;
    }
    const bool closed = time - windowStart_ >= windowLength();
    const bool needed = windowRungs_ > 0 || (closed && windowRungs_ < -1);
    if (needed)
    {
        change(K(windowRungs_));
        windowRungs_ = 0;
    }
    if (closed)
    {
        openWindow(time);
    }
    return needed;
}

bool SoundSpeed::exceeds(const scalar load) const
{
    const label n = particles_.granular().end;
    const scalar* Ux = particles_.U.x.data();
    const scalar* Uy = particles_.U.y.data();
    const scalar* p = particles_.p.data();
    const scalar USqr = load/eos_.rho0();
    label fast = 0, pressed = 0;
    #pragma omp parallel for simd schedule(static) reduction(+: fast, pressed)
    for (label i = 0; i < n; ++i)
    {
        fast += Ux[i]*Ux[i] + Uy[i]*Uy[i] > USqr;
        pressed += p[i] > load;
    }
    const label few = std::max(4, n/200);
    return fast > few || (pressed > few && weight() > load);
}

scalar SoundSpeed::weight() const
{
    const label n = particles_.granular().end;
    const scalar* x = particles_.r.x.data();
    const scalar* y = particles_.r.y.data();
    const scalar gx = g_.x(), gy = g_.y();
    scalar highest = g_.dot(particles_.r[0]), lowest = highest;
    #pragma omp parallel for simd schedule(static) \
        reduction(min: highest) reduction(max: lowest)
    for (label i = 0; i < n; ++i)
    {
        const scalar depth = gx*x[i] + gy*y[i];
        highest = depth < highest ? depth : highest;
        lowest = depth > lowest ? depth : lowest;
    }
    return eos_.rho0()*(lowest - highest + g_.norm()*particles_.spacing());
}

void SoundSpeed::change(const scalar K)
{
    const scalar before = eos_.c();
    eos_.correct(particles_.granular(), particles_.rho, particles_.p);
    eos_.setK(K);
    for
    (
        const ParticleRange& range :
        {particles_.granular(), particles_.walls()}
    )
    {
        const bool granular = range.begin == particles_.granular().begin;
        #pragma omp parallel for schedule(static)
        for (label i = range.begin; i < range.end; ++i)
        {
            if (particles_.p[i] > 0)
            {
                particles_.rho[i] = eos_.density(particles_.p[i]);
            }
            particles_.V[i] = particles_.m[i]/particles_.rho[i];
            particles_.Vg[i] = granular ? particles_.V[i] : 0;
        }
    }
    std::cout << "Sound speed " << before << " -> " << eos_.c() << " m/s";
    if (eos_.adaptive())
    {
        const scalar U = eos_.c()/std::sqrt(eos_.KFactor());
        std::cout << " (for speeds up to " << U
            << " m/s and pressure heads up to " << U*U/g_.norm() << " m)";
    }
    std::cout << '\n';
}

static std::filesystem::path fileOf(const std::filesystem::path& timeFolder)
{
    return timeFolder/"uniform"/"equationOfState";
}

static void writeEntries
(
    const std::filesystem::path& timeFolder,
    const std::map<word, scalar>& entries
)
{
    writeFile
    (
        fileOf(timeFolder),
        [&](std::ostream& os)
        {
            os  << std::setprecision(17)
                << "FoamFile\n{\n"
                << "    version     2.0;\n"
                << "    format      ascii;\n"
                << "    class       dictionary;\n"
                << "    location    \""
                << timeFolder.filename().string() << "/uniform\";\n"
                << "    object      equationOfState;\n"
                << "}\n";
            for (const auto& [key, value] : entries)
            {
                os  << '\n' << std::left << std::setw(16) << key
                    << value << ";\n";
            }
        }
    );
}

void SoundSpeed::read(const std::filesystem::path& timeFolder)
{
    const std::filesystem::path file = fileOf(timeFolder);
    if (!std::filesystem::exists(file))
    {
        return;
    }
    const dictionary dict = dictionary::fromFile(file);
    const scalar K = eos_.K();
    eos_.setK(dict.get("K", dimPressure, Range::positive()));
    if (!eos_.adaptive())
    {
        if (eos_.K() != K)
        {
            change(K);
        }
        return;
    }
    openWindow(windowStart_);
    windowStart_ = dict.getOrDefault("windowStart", windowStart_, dimTime);
    windowRungs_ = label
    (
        dict.getOrDefault
        (
            "windowRungs", windowRungs_, dimless,
            Range::between(-mostRungsDown, 0)
        )
    );
}

void SoundSpeed::write(const std::filesystem::path& timeFolder) const
{
    if (!eos_.adaptive())
    {
        write(timeFolder, eos_.K());
        return;
    }
    writeEntries
    (
        timeFolder,
        {
            {"K", eos_.K()},
            {"windowStart", windowStart_},
            {"windowRungs", windowRungs_}
        }
    );
}

void SoundSpeed::write
(
    const std::filesystem::path& timeFolder, const scalar K
)
{
    writeEntries(timeFolder, {{"K", K}});
}

} // namespace sph
