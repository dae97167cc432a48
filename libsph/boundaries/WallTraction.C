#include "boundaries/WallTraction.H"

#include <algorithm>

namespace sph
{

WallTraction::WallTraction
(
    Particles& particles, const Boundaries& boundaries,
    const EquationOfState& eos, const vector& g
)
:
    particles_(particles),
    boundaries_(boundaries),
    eos_(eos),
    g_(g),
    any_(boundaries.anyFriction())
{
    if (any_)
    {
        particles.use("tauWall");
    }
}

template<class Act>
void WallTraction::forEach(const Act& act) const
{
    if (!any_)
    {
        return;
    }
    const ParticleRange walls = particles_.walls();
    for (label w = walls.begin; w < walls.end; ++w)
    {
        const Boundary& patch = *boundaries_.patches()[particles_.patch[w]];
        if (patch.muWall() > 0)
        {
            act(w, patch);
        }
    }
}

// Along the tangent (n.y, -n.x)
scalar WallTraction::slipVelocity
(
    const label w, const Boundary& patch
) const
{
    const vector n = particles_.n[w];
    return vector(n.y(), -n.x()).dot
    (
        particles_.U[w] - patch.friction().velocity
    );
}

void WallTraction::stick(const scalar deltaT)
{
    const scalar k = eos_.K()/(2*particles_.spacing());
    forEach([&](const label w, const Boundary& patch)
    {
        particles_.tauWall[w] += k*deltaT*slipVelocity(w, patch);
    });
}

void WallTraction::slip()
{
    const scalar impedance = 0.5*eos_.rho0()*eos_.c();
    forEach([&](const label w, const Boundary& patch)
    {
        const vector n = particles_.n[w], t(n.y(), -n.x());
        const tensor s = particles_.s[w];
        const scalar depth = particles_.depth[w];
        const scalar N =
            particles_.p[w] + particles_.q[w]
          + particles_.rho[w]*depth*g_.dot(n) - n.dot(s*n);
        const scalar limit = patch.muWall()*std::max(N, 0.0);

        scalar& elastic = particles_.tauWall[w];
        elastic = std::clamp(elastic, -limit, limit);
        const scalar tau = std::clamp
        (
            elastic + impedance*slipVelocity(w, patch), -limit, limit
        );
        particles_.s.set
        (
            w, s + 2*tau*(t*n.transpose() + n*t.transpose())
        );
    });
}

} // namespace sph
