#include "scheme/Burden.H"

#include <algorithm>

namespace sph
{

Burden::Burden
(
    const Particles& particles, const vector& g, const scalar rho0
)
:
    particles_(particles),
    g_(g),
    rho0_(rho0)
{}

bool Burden::exceeds(const scalar load) const
{
    const label n = particles_.granular().end;
    const scalar* Ux = particles_.U.x.data();
    const scalar* Uy = particles_.U.y.data();
    const scalar* p = particles_.p.data();
    const scalar USqr = load/rho0_;
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

scalar Burden::height() const
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
    return (lowest - highest)/g_.norm() + particles_.spacing();
}

scalar Burden::weight() const
{
    return rho0_*g_.norm()*height();
}

scalar Burden::greatestPressure() const
{
    const auto p = particles_.p.begin();
    return *std::max_element(p, p + particles_.granular().end);
}

} // namespace sph
