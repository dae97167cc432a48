#include "scheme/Guard.H"

#include "io/caseIO.H"
#include "io/writeTimeFolder.H"
#include "scheme/BulkModulusState.H"
#include "scheme/SoundSpeed.H"

#include <cmath>
#include <sstream>

namespace sph
{

Guard::Guard
(
    const dictionary& solution, const Particles& particles,
    const Material& material
)
:
    material_(material)
{
    const dictionary& domain = solution.subOrEmptyDict
    (
        {"domain", "box that no particle may leave"}
    );
    vector min = particles.r[0], max = particles.r[0];
    for (const ParticleRange& range : {particles.granular(), particles.walls()})
    {
        for (label i = range.begin; i < range.end; ++i)
        {
            min = min.cwiseMin(particles.r[i]);
            max = max.cwiseMax(particles.r[i]);
        }
    }
    const scalar margin = 10*(max - min).norm();
    min_ = domain.getVectorOrDefault
    (
        {
            "min", "its lower corner; else ten sizes of the scene away",
            "(-1 -1 0)"
        },
        min - vector::Constant(margin), dimLength
    );
    max_ = domain.getVectorOrDefault
    (
        {
            "max", "its upper corner; else ten sizes of the scene away",
            "(1 1 0)"
        },
        max + vector::Constant(margin), dimLength
    );
    for (label i = 0; i < particles.granular().end; ++i)
    {
        const vector r = particles.r[i];
        if ((r.array() < min_.array()).any() || (r.array() > max_.array()).any())
        {
            domain.fail
            (
                "max", "Particle " + std::to_string(particles.id[i])
              + " starts outside the domain"
            );
        }
    }
}

// A comparison with a number that is not finite is false
static bool soundParticle
(
    const Particles& P, const label i,
    const vector& min, const vector& max,
    const scalar cP, const scalar aMax, const scalar rho0
)
{
    const scalar USqr = P.U.x[i]*P.U.x[i] + P.U.y[i]*P.U.y[i];
    return
        (P.r.x[i] >= min.x()) & (P.r.x[i] <= max.x())
      & (P.r.y[i] >= min.y()) & (P.r.y[i] <= max.y())
      & (USqr <= cP*cP)
      & (P.rho[i] > 0.1*rho0) & (P.rho[i] < 10*rho0)
      & (std::abs(P.a.x[i]) + std::abs(P.a.y[i]) < aMax);
}

void Guard::check(Particles& particles, const Time& runTime)
{
    if (sound(particles))
    {
        if (runTime.index() % interval == 0)
        {
            keep(particles, runTime.value());
        }
        return;
    }
    const std::string message =
        diagnosis(particles, runTime.value(), runTime.deltaT());
    restore(particles);
    if (!keptIsWritten_)
    {
        write(particles, runTime);
    }
    throw Error
    (
        message + "\nThe last good state was written to time "
      + runTime.timeName(keptTime_) + "."
    );
}

void Guard::write(const Particles& particles, const Time& runTime) const
{
    writeTimeFolder
    (
        runTime.caseDir()/runTime.timeName(keptTime_),
        [&](const std::filesystem::path& folder)
        {
            BulkModulusState{keptK_}.write(folder);
            writeState
            (
                particles, keptTime_, folder,
                {
                    runTime.writeAscii(), runTime.writeCompressed(),
                    runTime.writePrecision()
                }
            );
        }
    );
    writeSeries(runTime.caseDir());
}

scalar Guard::aMax(const Particles& particles) const
{
    return 10*std::pow(material_.cP(), 2)/particles.spacing();
}

bool Guard::sound(const Particles& particles) const
{
    const label n = particles.granular().end;
    const scalar cP = material_.cP(), rho0 = material_.rho0();
    const scalar aMax = this->aMax(particles);
    label bad = 0;
    #pragma omp parallel for simd schedule(static) reduction(+: bad)
    for (label i = 0; i < n; ++i)
    {
        bad += !soundParticle(particles, i, min_, max_, cP, aMax, rho0);
    }
    return bad == 0;
}

void Guard::keep
(
    const Particles& particles, const scalar time, const bool written
)
{
    keptIsWritten_ = written;
    const label n = particles.granular().end;
    keptTime_ = time;
    keptK_ = material_.eos().K();
    keptR_.x.assign(particles.r.x.begin(), particles.r.x.begin() + n);
    keptR_.y.assign(particles.r.y.begin(), particles.r.y.begin() + n);
    keptId_.assign(particles.id.begin(), particles.id.begin() + n);
    std::size_t k = 0;
    for (const FieldInfo& info : particles.fields())
    {
        for (const scalarField* c : info.components)
        {
            if (kept_.size() <= k)
            {
                kept_.emplace_back();
            }
            kept_[k++].assign(c->begin(), c->begin() + n);
        }
    }
}

void Guard::restore(Particles& particles) const
{
    std::copy(keptR_.x.begin(), keptR_.x.end(), particles.r.x.begin());
    std::copy(keptR_.y.begin(), keptR_.y.end(), particles.r.y.begin());
    std::copy(keptId_.begin(), keptId_.end(), particles.id.begin());
    std::size_t k = 0;
    for (const FieldInfo& info : particles.fields())
    {
        for (scalarField* c : info.components)
        {
            std::copy(kept_[k].begin(), kept_[k].end(), c->begin());
            ++k;
        }
    }
}

std::string Guard::diagnosis
(
    const Particles& particles, const scalar time, const scalar deltaT
) const
{
    const scalar cP = material_.cP(), rho0 = material_.rho0();
    const scalar aMax = this->aMax(particles);
    label worst = 0;
    label bad = 0;
    for (label i = particles.granular().end - 1; i >= 0; --i)
    {
        if (!soundParticle(particles, i, min_, max_, cP, aMax, rho0))
        {
            worst = i;
            ++bad;
        }
    }
    const vector r = particles.r[worst], U = particles.U[worst];
    const scalar rho = particles.rho[worst];
    const bool finite =
        std::isfinite(r.sum()) && std::isfinite(U.sum()) && std::isfinite(rho)
     && std::isfinite(particles.a[worst].sum());
    const bool inside =
        (r.array() >= min_.array()).all() && (r.array() <= max_.array()).all();

    std::ostringstream os;
    os << "The run went wrong at time " << time << ": " << bad
        << (bad == 1 ? " particle is" : " particles are")
        << " not sound, first particle " << particles.id[worst]
        << " at (" << r.x() << ' ' << r.y() << "): ";
    if (!finite)
    {
        os << "its numbers are not finite";
    }
    else if (!inside)
    {
        os << "it left the domain (" << min_.x() << ' ' << min_.y()
            << ") to (" << max_.x() << ' ' << max_.y() << ')';
    }
    else if (U.norm() > cP)
    {
        os << "its speed " << U.norm() << " m/s exceeds that of pressure"
            << " waves, " << cP << " m/s";
    }
    else if (particles.a[worst].norm() > 0.5*aMax)
    {
        os << "its acceleration is " << particles.a[worst].norm() << " m/s2";
    }
    else
    {
        os << "its density is " << rho << " kg/m3, " << rho0 << " at rest";
    }
    os << "\n\nThe step was deltaT = " << deltaT << " s. What to try:\n";
    if (finite && !inside)
    {
        os << "  - a longer wall in constant/boundary where it left, or a"
            << " larger domain in system/sphSolution\n";
    }
    os << "  - a smaller maxCo in system/controlDict (0.2)\n"
        << "  - a greater KFactor of the equation of state,";
    if (material_.eos().adaptive())
    {
        os << " or H: K follows up to " << SoundSpeed::maxRise
            << " times that of H\n";
    }
    else
    {
        os << " or adaptive yes, if speeds come near that of sound\n";
    }
    os << "  - stabilisation, artificialViscosity and shifting other than"
        << " none in system/sphSchemes\n";
    return os.str();
}

} // namespace sph
