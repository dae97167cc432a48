// What a scheme is made of, and which sums it makes in one pass.
#include "scheme/Scheme.H"

#include <algorithm>
#include <iostream>

namespace sph
{

static std::unique_ptr<ViscousScheme> newViscousScheme
(
    const dictionary& schemes, const dictionary& solution,
    const Particles& particles, const Boundaries& boundaries,
    const Material& material
)
{
    auto scheme = ViscousScheme::New
    (
        schemes,
        {
            "viscousScheme", "how the shear stress makes a force",
            "stressDivergence"
        },
        particles
    );
    if (boundaries.anyFriction() && !scheme->stressCarriesShear())
    {
        schemes.fail
        (
            "viscousScheme",
            "A CoulombWall acts by its stress: it needs viscousScheme"
            " stressDivergence"
        );
    }
    if (!material.rheology().elastic())
    {
        return scheme;
    }
    if (!scheme->stressCarriesShear())
    {
        schemes.fail
        (
            "viscousScheme",
            "An elastic rheology carries its stress: it needs"
            " viscousScheme stressDivergence"
        );
    }
    if (ImplicitViscosity::selected(solution))
    {
        solution.fail
        (
            "viscousIntegration",
            "An elastic rheology has no viscosity that limits the step:"
            " viscousIntegration explicit"
        );
    }
    return scheme;
}

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
            schemes, {"kernel", "interpolating function W", "cubicSpline"},
            particles.spacing()*schemes.getOrDefault
            (
                {"hByDx", "smoothing length over the spacing"}, 1.3,
                dimless, Range::between(1, 3)
            )
        )
    ),
    neighbourhood_
    (
        particles, boundaries, kernel_->cutOff(),
        kernel_->h()*solution.getOrDefault
        (
            {"skin", "reach of the pair lists beyond the kernel's, over h"},
            0.16, dimless, Range::between(0.01, 2)
        )
    ),
    gradientWalk_(particles),
    forceWalk_(particles),
    wallVelocityWalk_(particles),
    wallStressWalk_(particles),
    correction_
    (
        Correction::New
        (
            schemes,
            {"correction", "correction of kernel gradients", "bulkBlended"}
        )
    ),
    shifting_
    (
        Shifting::New
        (
            schemes,
            {"shifting", "keeps particles evenly spread", "strainRate"},
            particles, *kernel_
        )
    ),
    stressDivergence_(g),
    viscousScheme_
    (
        newViscousScheme(schemes, solution, particles, boundaries, material)
    ),
    artificialViscosity_
    (
        ArtificialViscosity::New
        (
            schemes,
            {
                "artificialViscosity", "numerical dissipation of velocity",
                "gradientCorrected"
            },
            material.eos(), *kernel_
        )
    ),
    stabilisation_
    (
        Stabilisation::New
        (
            schemes,
            {"stabilisation", "diffusion of density noise", "deltaSPH"},
            material.eos(), *kernel_
        )
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
    wallTraction_(particles, boundaries, material.eos(), g),
    wallForces_(particles, boundaries)
{
    if (viscousScheme_->needsExactGradU() && !correction_->isExact())
    {
        schemes.fail
        (
            "correction",
            "viscousScheme " + schemes.get<word>("viscousScheme")
          + " needs corrected gradients: correction kernelGradient or"
            " bulkBlended"
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
    if (forcesUse("gradU") || material.turbulence().any())
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

} // namespace sph
