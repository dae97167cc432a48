#include "benchmarks/CollapseScene.H"

namespace sph
{

CollapseScene::CollapseScene(const label nr)
:
    spacing_(r0_/nr),
    properties_
    (
        dictionary::fromFile(tutorial()/"constant"/"granularProperties")
    ),
    boundary_(dictionary::fromFile(tutorial()/"constant"/"boundary")),
    schemes_(dictionary::fromFile(tutorial()/"system"/"sphSchemes")),
    solution_(dictionary::fromFile(tutorial()/"system"/"sphSolution")),
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
    const std::vector<WallParticle> walls = boundaries_.wallParticles();
    particles_.resize(nx*ny, label(walls.size()));

    const scalar mass = material_.rho0()*spacing_*spacing_;
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
            particles_.m[i] = mass;
            particles_.id[i] = i;
        }
    }
    i = particles_.walls().begin;
    for (const WallParticle& wall : walls)
    {
        particles_.r.set(i, wall.r);
        particles_.n.set(i, wall.n);
        particles_.depth[i] = wall.depth;
        particles_.patch[i] = wall.patch;
        particles_.rho[i] = material_.rho0();
        particles_.m[i] = mass;
        ++i;
    }
}

scalar CollapseScene::neighboursPerParticle() const
{
    const Neighbourhood& n = const_cast<Scheme&>(scheme_).neighbourhood();
    return scalar(n.granularPairs().pairCount())/size();
}

} // namespace sph
