// The parts of a step.
#include "scheme/Scheme.H"

#include "particles/team.H"

#include <algorithm>

namespace sph
{

void Scheme::updatePairs()
{
    neighbourhood_.update();
    rebuilt_ = neighbourhood_.rebuilds() != rebuilds_;
    rebuilds_ = neighbourhood_.rebuilds();
    if (!rebuilt_)
    {
        return;
    }
    // A sort loses what follows from the state
    shareOut
    (
        particles_.awake(), [&](const auto& some) { setVolumes(some); }
    );
    if (particles_.sleepers().size() > 0)
    {
        setSleepers();
    }
}

// What follows from the state of those that do not move. Gradients are made
// afterwards, of those that others see.
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
            &P.gradU.xx, &P.gradU.xy, &P.gradU.yx, &P.gradU.yy,
            &P.L.xx, &P.L.xy, &P.L.yy, &P.w
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
    #pragma omp simd
    for (label i = range.begin; i < range.end; ++i)
    {
        V[i] = Vg[i] = m[i]/rho[i];
    }
}

void Scheme::extrapolateVelocity()
{
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

// rho += dt (-rho div + rhoDot)
void Scheme::continuity(const ParticleRange& range, const scalar deltaT)
{
    scalar* rho = particles_.rho.data();
    const scalar* div = particles_.div.data();
    const scalar* rhoDot = particles_.rhoDot.data();
    scalar* V = particles_.V.data();
    scalar* Vg = particles_.Vg.data();
    const scalar* m = particles_.m.data();
    #pragma omp simd
    for (label i = range.begin; i < range.end; ++i)
    {
        rho[i] += deltaT*(rhoDot[i] - rho[i]*div[i]);
        V[i] = Vg[i] = m[i]/rho[i];
    }
}

void Scheme::pressure(const ParticleRange& range)
{
    material_.eos().correct(range, particles_.rho, particles_.p);
    artificialViscosity_->bulkPressure(particles_, range);
}

// T = [-(p + q) 1 + s]/rho^2
void Scheme::setStress(const ParticleRange& range)
{
    using namespace of;
    const scalar shear = viscousScheme_->stressCarriesShear() ? 1 : 0;
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

void Scheme::stress(const ParticleRange& range)
{
    setStress(range);
    material_.turbulence().addStress(particles_, range);
}

void Scheme::correctMaterial(const scalar deltaT)
{
    shareOut
    (
        particles_.awake(),
        [&](const ParticleRange& some)
        {
            continuity(some, deltaT);
            pressure(some);
            material_.rheology().correct(particles_, some, deltaT);
            stress(some);
        }
    );
    wallTraction_.stick(deltaT);
}

void Scheme::pressure()
{
    shareOut(particles_.awake(), [&](const auto& some) { pressure(some); });
}

void Scheme::stress()
{
    shareOut(particles_.awake(), [&](const auto& some) { stress(some); });
}

void Scheme::extrapolateStress()
{
    neighbourhood_.refreshImages(wallStressWalk_.fields());
    wallStressWalk_.run(neighbourhood_.wallPairs(), *kernel_);
    wallTraction_.slip();
    stress(particles_.walls());
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
    addSideWallDrag(deltaT);
}

void Scheme::addSideWallDrag(const scalar deltaT)
{
    if (material_.sideWalls().any())
    {
        shareOut
        (
            particles_.active(),
            [&](const ParticleRange& some)
            {
                material_.sideWalls().addDrag(particles_, some, deltaT);
            }
        );
    }
}

void Scheme::initialise()
{
    updatePairs();
    extrapolateVelocity();
    gradients();
    pressure();
    stress();
    extrapolateStress();
    forces(0);
}

} // namespace sph
