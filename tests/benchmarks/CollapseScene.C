#include "benchmarks/CollapseScene.H"

#include <fstream>
#include <sstream>

namespace sph
{

void MaterialState::resize(const label n)
{
    for
    (
        scalarField* f :
        {&r.x, &r.y, &U.x, &U.y, &rho, &m, &s.xx, &s.xy, &s.yy}
    )
    {
        f->resize(n);
    }
}

// A dictionary of the tutorial; entries that come later replace earlier ones
static dictionary read(const char* file, const std::string& changes = "")
{
    const auto path =
        std::filesystem::path(SPH_PROJECT_ROOT)
       /"tutorials/granularFoamSPH/columnCollapse/sandA0.9"/file;
    std::ostringstream text;
    text << std::ifstream(path).rdbuf() << '\n' << changes;
    return dictionary::fromString(text.str(), path.string());
}

CollapseScene::CollapseScene(const label nr, const Changes& changes)
:
    spacing_(r0_/nr),
    properties_(read("constant/granularProperties", changes.properties)),
    boundary_(read("constant/boundary")),
    schemes_(read("system/sphSchemes", changes.schemes)),
    solution_(read("system/sphSolution")),
    particles_(spacing_),
    material_(properties_, g_, spacing_),
    boundaries_(boundary_, spacing_),
    scheme_
    (
        schemes_, solution_,
        (fill(), particles_), boundaries_, material_, g_
    ),
    integrator_(Integrator::New(solution_, "integrator")),
    timeStep_(solution_, material_, scheme_.kernel().h()),
    deltaT_(0.4*timeStep_.stable(particles_))
{
    scheme_.initialise();
}

// Hydrostatic column on a square lattice, and its bed
void CollapseScene::fill()
{
    const label nx = std::lround(r0_/spacing_), ny = std::lround(h0_/spacing_);
    particles_.resize(nx*ny, label(boundaries_.wallParticles().size()));

    label i = 0;
    for (label iy = 0; iy < ny; ++iy)
    {
        for (label ix = 0; ix < nx; ++ix, ++i)
        {
            const vector r((ix + 0.5)*spacing_, (iy + 0.5)*spacing_);
            particles_.r.set(i, r);
            particles_.rho[i] = material_.eos().density
            (
                material_.rho0()*g_.norm()*(h0_ - r.y())
            );
            particles_.m[i] = material_.rho0()*spacing_*spacing_;
            particles_.id[i] = i;
        }
    }
    boundaries_.placeWalls(material_.rho0(), particles_);
}

// Velocity and density vary linearly within the square of a particle
CollapseScene::StatePtr CollapseScene::refined(const label k) const
{
    MaterialState fine;
    fine.resize(size()*k*k);
    label n = 0;
    for (label i = 0; i < size(); ++i)
    {
        for (label child = 0; child < k*k; ++child, ++n)
        {
            const vector dr =
                spacing_/k
               *vector(child % k - 0.5*(k - 1), child/k - 0.5*(k - 1));
            fine.r.set(n, particles_.r[i] + dr);
            fine.U.set(n, particles_.U[i] + particles_.gradU[i]*dr);
            fine.rho[n] = particles_.rho[i] + particles_.gradRho[i].dot(dr);
            fine.m[n] = particles_.m[i]/(k*k);
            fine.s.set(n, particles_.s[i]);
        }
    }
    return std::make_shared<MaterialState>(std::move(fine));
}

void CollapseScene::rewind()
{
    const MaterialState& start = *start_;
    const label n = label(start.rho.size());
    particles_.resize(n, particles_.walls().size());
    for (label i = 0; i < n; ++i)
    {
        particles_.r.set(i, start.r[i]);
        particles_.U.set(i, start.U[i]);
        particles_.rho[i] = start.rho[i];
        particles_.m[i] = start.m[i];
        particles_.s.set(i, start.s[i]);
        particles_.id[i] = i;
    }
    boundaries_.placeWalls(material_.rho0(), particles_);
    scheme_.neighbourhood().reset();
    scheme_.initialise();
    steps_ = 0;
}

void CollapseScene::step()
{
    clock_.start();
    move(deltaT_);
    clock_.lap(Part::move);

    const label before = rebuilds();
    scheme_.updatePairs();
    clock_.lap(rebuilds() > before ? Part::rebuild : Part::images);

    wallVelocity();
    clock_.lap(Part::wallVelocity);
    gradients();
    clock_.lap(Part::gradients);
    pointwise(deltaT_);
    clock_.lap(Part::pointwise);
    wallStress();
    clock_.lap(Part::wallStress);
    scheme_.forces(deltaT_);
    clock_.lap(Part::forces);

    integrator_->end(particles_, deltaT_);
    clock_.lap(Part::move);
    timeStep_.printCourant(particles_, deltaT_);
    clock_.lap(Part::courantNumber);
    ++steps_;
}

} // namespace sph
