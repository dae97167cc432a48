#include "scheme/Scheme.H"

#include "particles/worthATeam.H"

#include <algorithm>
#include <iostream>

namespace sph
{

Scheme::Scheme
(
    const dictionary& schemes, const dictionary& solution,
    Particles& particles, const Boundaries& boundaries,
    const Material& material, const vector& g
)
:
    particles_(particles),
    material_(material),
    kernel_
    (
        Kernel::New
        (
            schemes, "kernel",
            particles.spacing()
           *schemes.getOrDefault("hByDx", 1.3, dimless, Range::between(1, 3))
        )
    ),
    neighbourhood_
    (
        particles, boundaries, kernel_->cutOff(),
        kernel_->h()
       *solution.getOrDefault("skin", 0.16, dimless, Range::between(0.01, 2))
    ),
    gradientWalk_(particles),
    forceWalk_(particles),
    wallVelocityWalk_(particles),
    wallStressWalk_(particles),
    correction_(Correction::New(schemes, "correction")),
    shifting_(Shifting::New(schemes, "shifting", particles, *kernel_)),
    stressDivergence_(g),
    viscousScheme_(ViscousScheme::New(schemes, "viscousScheme", particles)),
    artificialViscosity_
    (
        ArtificialViscosity::New
        (
            schemes, "artificialViscosity", material.eos(), *kernel_
        )
    ),
    stabilisation_
    (
        Stabilisation::New(schemes, "stabilisation", material.eos(), *kernel_)
    ),
    implicitViscosity_
    (
        ImplicitViscosity::New
        (
            solution, *viscousScheme_, particles, boundaries, neighbourhood_,
            *kernel_
        )
    ),
    wallVelocity_(particles, boundaries),
    wallStress_(particles, boundaries, material.eos(), g),
    wallVelocityGradient_(particles, boundaries),
    wallForces_(particles, boundaries)
{
    if
    (
        material.rheology().elastic() && !viscousScheme_->stressCarriesShear()
    )
    {
        schemes.fail
        (
            "viscousScheme",
            "An elastic rheology carries its stress: it needs"
            " viscousScheme stressDivergence"
        );
    }

    gradientWalk_.add(*correction_);
    gradientWalk_.add(velocityGradient_);
    if (stabilisation_->needsGradRho())
    {
        gradientWalk_.add(densityGradient_);
    }
    gradientWalk_.add(*shifting_);

    forceWalk_.add(stressDivergence_);
    forceWalk_.add(*artificialViscosity_);
    forceWalk_.add(*stabilisation_);
    if (!viscousScheme_->stressCarriesShear() && !implicitViscosity_)
    {
        forceWalk_.add(*viscousScheme_);
    }

    addWallForces();

    wallVelocityWalk_.add(wallVelocity_);
    wallStressWalk_.add(wallStress_);
    if (forcesUse("gradU"))
    {
        wallStressWalk_.add(wallVelocityGradient_);
    }
    if (forcesUse("eta") || implicitViscosity_)
    {
        wallStressWalk_.add(wallViscosity_);
    }

    for
    (
        const char* entry :
        {
            "kernel", "correction", "viscousScheme", "artificialViscosity",
            "stabilisation", "shifting"
        }
    )
    {
        std::cout << "Selecting " << entry << ' '
            << schemes.get<word>(entry) << '\n';
    }
}

// The terms of the force walk that walls and material exert on each other
void Scheme::addWallForces()
{
    wallForces_.add(*artificialViscosity_);
    if (implicitViscosity_)
    {
        wallForces_.refuse
        (
            "Forces on walls are not available with viscousIntegration"
            " implicit"
        );
    }
    else if (!viscousScheme_->conservesMomentum())
    {
        wallForces_.refuse
        (
            "Forces on walls are not available with this viscousScheme: its"
            " forces between two particles are not opposite to each other"
        );
    }
    else if (!viscousScheme_->stressCarriesShear())
    {
        wallForces_.add(*viscousScheme_);
    }
}

bool Scheme::forcesUse(const std::string& field) const
{
    const auto& fields = forceWalk_.fields();
    return std::any_of
    (
        fields.begin(), fields.end(),
        [&](const FieldInfo* info) { return info->name == field; }
    );
}

void Scheme::updatePairs()
{
    neighbourhood_.update();
    rebuilt_ = neighbourhood_.rebuilds() != rebuilds_;
    rebuilds_ = neighbourhood_.rebuilds();
    if (rebuilt_ && particles_.sleepers().size() > 0)
    {
        setSleepers();
    }
}

// What follows from the state of those that do not move; a sort loses it
void Scheme::setSleepers()
{
    const ParticleRange range = particles_.sleepers();
    setVolumes(range);
    material_.eos().correct(range, particles_.rho, particles_.p);
    Particles& P = particles_;
    for
    (
        scalarField* rate :
        {
            &P.q, &P.div, &P.gammaDot, &P.I, &P.gradRho.x, &P.gradRho.y,
            &P.gradU.xx, &P.gradU.xy, &P.gradU.yx, &P.gradU.yy
        }
    )
    {
        std::fill_n(rate->data() + range.begin, range.size(), 0);
    }
    setStress(range);
}

// V = m/rho
void Scheme::setVolumes(const ParticleRange& range)
{
    scalar* V = particles_.V.data();
    scalar* Vg = particles_.Vg.data();
    const scalar* m = particles_.m.data();
    const scalar* rho = particles_.rho.data();
    #pragma omp parallel for simd schedule(static)
    for (label i = range.begin; i < range.end; ++i)
    {
        V[i] = Vg[i] = m[i]/rho[i];
    }
}

void Scheme::extrapolateVelocity()
{
    setVolumes(particles_.awake());
    neighbourhood_.refreshImages(wallVelocityWalk_.fields());
    wallVelocityWalk_.run(neighbourhood_.wallPairs(), *kernel_);
    neighbourhood_.refreshImages(gradientWalk_.fields());
}

void Scheme::gradients()
{
    // Those of sleepers that others see stay as they are between rebuilds
    const label end =
        rebuilt_ ? particles_.active().end : particles_.awake().end;
    gradientWalk_.run(neighbourhood_.granularPairs(), *kernel_, end);
}

void Scheme::continuity(const scalar deltaT)
{
    const label n = particles_.awake().end;
    scalar* rho = particles_.rho.data();
    const scalar* div = particles_.div.data();
    const scalar* rhoDot = particles_.rhoDot.data();
    scalar* V = particles_.V.data();
    scalar* Vg = particles_.Vg.data();
    const scalar* m = particles_.m.data();
    #pragma omp parallel for simd schedule(static)
    for (label i = 0; i < n; ++i)
    {
        rho[i] += deltaT*(rhoDot[i] - rho[i]*div[i]);
        V[i] = Vg[i] = m[i]/rho[i];
    }
}

void Scheme::pressure()
{
    const ParticleRange range = particles_.awake();
    material_.eos().correct(range, particles_.rho, particles_.p);
    artificialViscosity_->bulkPressure(particles_, range);
}

void Scheme::rheology(const scalar deltaT)
{
    material_.rheology().correct(particles_, particles_.awake(), deltaT);
}

// T = [-(p + q) 1 + s]/rho^2
void Scheme::setStress(const ParticleRange& range)
{
    using namespace of;
    const scalar shear = viscousScheme_->stressCarriesShear() ? 1 : 0;
    #pragma omp parallel for schedule(static) if(worthATeam(range.size()))
    for
    (
        label first = range.begin; first < range.end; first += width<lanes>
    )
    {
        const ParticleValues<lanes> i(particles_, first);
        const lanes invRhoSqr = 1.0/(i(rho)*i(rho));
        const symmTensorLanes sigma = shear*i(s);
        const lanes P = i(p) + i(q);
        i.set(T, invRhoSqr*symmTensorLanes{sigma.xx - P, sigma.xy, sigma.yy - P});
    }
}

void Scheme::extrapolateStress()
{
    setStress(particles_.awake());
    material_.turbulence().addStress(particles_, particles_.awake());

    neighbourhood_.refreshImages(wallStressWalk_.fields());
    wallStressWalk_.run(neighbourhood_.wallPairs(), *kernel_);
    setStress(particles_.walls());
    neighbourhood_.refreshImages(forceWalk_.fields());
}

void Scheme::forces(const scalar deltaT)
{
    stabilisation_->setDeltaT(deltaT);
    if (implicitViscosity_)
    {
        implicitViscosity_->guess(deltaT);
    }
    forceWalk_.run(neighbourhood_.granularPairs(), *kernel_);
    wallForces_.make(neighbourhood_.wallPairs(), *kernel_);
    if (implicitViscosity_)
    {
        implicitViscosity_->solve(deltaT);
    }
}

void Scheme::initialise()
{
    updatePairs();
    extrapolateVelocity();
    gradients();
    pressure();
    extrapolateStress();
    forces(0);
}

} // namespace sph
