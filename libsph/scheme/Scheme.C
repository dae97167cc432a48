#include "scheme/Scheme.H"

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
       *solution.getOrDefault("skin", 0.2, dimless, Range::between(0.01, 2))
    ),
    gradientWalk_(particles),
    forceWalk_(particles),
    wallVelocityWalk_(particles, PairWalk::Fetch::direct),
    wallStressWalk_(particles, PairWalk::Fetch::direct),
    correction_(Correction::New(schemes, "correction", gradientWalk_)),
    velocityGradient_(gradientWalk_),
    shifting_(Shifting::New(schemes, "shifting", gradientWalk_, *kernel_)),
    stressDivergence_(forceWalk_, g),
    viscousScheme_
    (
        ViscousScheme::New(schemes, "viscousScheme", forceWalk_)
    ),
    artificialViscosity_
    (
        ArtificialViscosity::New
        (
            schemes, "artificialViscosity", forceWalk_, material.eos(),
            *kernel_
        )
    ),
    stabilisation_
    (
        Stabilisation::New
        (
            schemes, "stabilisation", forceWalk_, material.eos(), *kernel_
        )
    ),
    wallVelocity_(wallVelocityWalk_, boundaries)
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
        densityGradient_ = std::make_unique<DensityGradient>(gradientWalk_);
        gradientWalk_.add(*densityGradient_);
    }
    if (shifting_->hasPairTerm())
    {
        gradientWalk_.add(*shifting_);
    }

    forceWalk_.add(stressDivergence_);
    if (!viscousScheme_->stressCarriesShear())
    {
        forceWalk_.add(*viscousScheme_);
    }
    if (artificialViscosity_->hasPairTerm())
    {
        forceWalk_.add(*artificialViscosity_);
    }
    if (stabilisation_->hasPairTerm())
    {
        forceWalk_.add(*stabilisation_);
    }

    wallVelocityWalk_.add(wallVelocity_);
    wallStress_ = std::make_unique<WallStress>
    (
        wallStressWalk_, boundaries, material.eos(), g,
        forcesUse("eta"), forcesUse("gradU")
    );
    wallStressWalk_.add(*wallStress_);

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
}

// V = m/rho
void Scheme::setVolumes()
{
    const label n = particles_.granular().end;
    scalar* V = particles_.V.data();
    scalar* Vg = particles_.Vg.data();
    const scalar* m = particles_.m.data();
    const scalar* rho = particles_.rho.data();
    #pragma omp parallel for simd schedule(static)
    for (label i = 0; i < n; ++i)
    {
        V[i] = Vg[i] = m[i]/rho[i];
    }
}

void Scheme::extrapolateVelocity()
{
    setVolumes();
    neighbourhood_.refreshImages(wallVelocityWalk_.fields());
    wallVelocityWalk_.run(neighbourhood_.wallPairs(), *kernel_);
    neighbourhood_.refreshImages(gradientWalk_.fields());
}

void Scheme::gradients()
{
    gradientWalk_.run(neighbourhood_.granularPairs(), *kernel_);
}

void Scheme::continuity(const scalar deltaT)
{
    const label n = particles_.granular().end;
    scalar* rho = particles_.rho.data();
    const scalar* div = particles_.div.data();
    const scalar* rhoDot = particles_.rhoDot.data();
    #pragma omp parallel for simd schedule(static)
    for (label i = 0; i < n; ++i)
    {
        rho[i] += deltaT*(rhoDot[i] - rho[i]*div[i]);
    }
    setVolumes();
}

void Scheme::pressure()
{
    const ParticleRange range = particles_.granular();
    material_.eos().correct(range, particles_.rho, particles_.p);
    artificialViscosity_->bulkPressure(particles_, range);
}

void Scheme::rheology(const scalar deltaT)
{
    material_.rheology().correct(particles_, particles_.granular(), deltaT);
}

// T = [-(p + q) 1 + s]/rho^2
void Scheme::setStress(const ParticleRange& range)
{
    const scalar shear = viscousScheme_->stressCarriesShear() ? 1 : 0;
    Particles& P = particles_;
    #pragma omp parallel for schedule(static)
    for (label i = range.begin; i < range.end; i += laneCount)
    {
        const lanes rho = load(&P.rho[i]);
        const lanes invRhoSqr = 1.0/(rho*rho);
        const lanes pressure = load(&P.p[i]) + load(&P.q[i]);
        store
        (
            invRhoSqr*(shear*load(&P.s.xx[i]) - pressure), &P.T.xx[i]
        );
        store(invRhoSqr*shear*load(&P.s.xy[i]), &P.T.xy[i]);
        store
        (
            invRhoSqr*(shear*load(&P.s.yy[i]) - pressure), &P.T.yy[i]
        );
    }
}

void Scheme::extrapolateStress()
{
    setStress(particles_.granular());
    material_.turbulence().addStress(particles_, particles_.granular());

    neighbourhood_.refreshImages(wallStressWalk_.fields());
    wallStressWalk_.run(neighbourhood_.wallPairs(), *kernel_);
    setStress(particles_.walls());
    neighbourhood_.refreshImages(forceWalk_.fields());
}

void Scheme::forces(const scalar deltaT)
{
    stabilisation_->setDeltaT(deltaT);
    forceWalk_.run(neighbourhood_.granularPairs(), *kernel_);
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
