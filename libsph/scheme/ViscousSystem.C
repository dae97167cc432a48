#include "scheme/ViscousSystem.H"

namespace sph
{

ViscousSystem::ViscousSystem
(
    const ViscousScheme& scheme, Particles& particles,
    const Boundaries& boundaries, Neighbourhood& neighbourhood,
    const Kernel& kernel
)
:
    particles_(particles),
    boundaries_(boundaries),
    neighbourhood_(neighbourhood),
    kernel_(kernel),
    terms_(scheme.implicitTerms(coefficients_)),
    coefficientWalk_(particles),
    productWalk_(particles),
    velocity_{&particles.field("U")}
{
    if (solvable())
    {
        coefficientWalk_.add(*terms_.coefficients);
        productWalk_.add(*terms_.product);
    }
}

void ViscousSystem::setWallFriction()
{
    Particles& P = particles_;
    for (label w = P.walls().begin; w < P.walls().end; ++w)
    {
        const WallFriction friction =
            boundaries_.patches()[P.patch[w]]->friction();
        P.betaT[w] = friction.tangential;
        P.betaN[w] = friction.normal;
        P.Uwall.set(w, friction.velocity);
    }
}

void ViscousSystem::assemble(const scalar deltaT)
{
    const std::size_t n = particles_.r.x.size();
    symmTensorField& wall = coefficients_.wall;
    symmTensorField& inverse = coefficients_.inverse;
    vectorField& source = coefficients_.wallSource;
    for
    (
        scalarField* field :
        {
            &wall.xx, &wall.xy, &wall.yy, &source.x, &source.y,
            &inverse.xx, &inverse.xy, &inverse.yy
        }
    )
    {
        resizeSparingly(*field, n);
    }
    coefficients_.deltaT = deltaT;
    setWallFriction();
    neighbourhood_.refreshImages(coefficientWalk_.fields());
    coefficientWalk_.run
    (
        neighbourhood_.granularPairs(), kernel_, particles_.awake().end
    );
}

void ViscousSystem::rightHandSide(Vector& b) const
{
    const Particles& P = particles_;
    const scalar dt = coefficients_.deltaT;
    const vectorField& source = coefficients_.wallSource;
    const label n = P.awake().end;
    #pragma omp parallel for simd schedule(static)
    for (label i = 0; i < n; ++i)
    {
        b[i] = P.m[i]*(P.U.x[i] + dt*P.a.x[i]) - source.x[i];
        b[n + i] = P.m[i]*(P.U.y[i] + dt*P.a.y[i]) - source.y[i];
    }
}

void ViscousSystem::multiply(const Vector& x, Vector& y) const
{
    set(particles_.U, x);
    neighbourhood_.refreshImages(velocity_);
    productWalk_.run
    (
        neighbourhood_.granularPairs(), kernel_, particles_.awake().end
    );
    get(particles_.a, y);
}

void ViscousSystem::precondition(const Vector& y, Vector& x) const
{
    const symmTensorField& D = coefficients_.inverse;
    const label n = particles_.awake().end;
    #pragma omp parallel for simd schedule(static)
    for (label i = 0; i < n; ++i)
    {
        const scalar yx = y[i], yy = y[n + i];
        x[i] = D.xx[i]*yx + D.xy[i]*yy;
        x[n + i] = D.xy[i]*yx + D.yy[i]*yy;
    }
}

void ViscousSystem::get(const vectorField& field, Vector& x) const
{
    const label n = particles_.awake().end;
    std::copy_n(field.x.data(), n, x.data());
    std::copy_n(field.y.data(), n, x.data() + n);
}

void ViscousSystem::set(vectorField& field, const Vector& x) const
{
    const label n = particles_.awake().end;
    std::copy_n(x.data(), n, field.x.data());
    std::copy_n(x.data() + n, n, field.y.data());
}

} // namespace sph
