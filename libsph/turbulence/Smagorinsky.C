// Static Smagorinsky model of the sub-particle-scale (SPS) stress.
//
//     tau  = rho (2 nut D - 2/3 k 1)                                     (3)
//     nut  = (Cs dx)^2 gammaDot                                          (4)
//     k    = (nut/(0.08 dx))^2                                           (5)
//
// Salehizadeh & Shafiei, Granular Matter 21:32 (2019), after Dalrymple &
// Rogers, Coast. Eng. 53, 141 (2006).
//
//     turbulence  Smagorinsky;
//     SmagorinskyCoeffs { Cs 0.2; }

#include "turbulence/Turbulence.H"

#include <cmath>

namespace sph
{
namespace
{

class Smagorinsky : public Turbulence
{
    const scalar dx_;
    const scalar CsDxSqr_;

public:
    Smagorinsky(const dictionary& dict, const scalar dx)
    :
        dx_(dx),
        CsDxSqr_
        (
            std::pow
            (
                dx*dict.getOrDefault
                (
                    {"Cs", "Smagorinsky's constant, Eq. 4"}, 0.2,
                    dimless, Range::nonNegative()
                ),
                2
            )
        )
    {}

    void addStress
    (
        Particles& particles, const ParticleRange& range
    ) const override
    {
        const tensorField& G = particles.gradU;
        for (label i = range.begin; i < range.end; ++i)
        {
            const scalar Dxx = 0.5*(G.xx[i] - G.yy[i]);
            const scalar Dxy = 0.5*(G.xy[i] + G.yx[i]);
            const scalar nut = CsDxSqr_*2*std::sqrt(Dxx*Dxx + Dxy*Dxy);
            const scalar k = nut*nut/(0.0064*dx_*dx_);
            const scalar invRho = 1/particles.rho[i];
            particles.T.xx[i] += invRho*(2*nut*G.xx[i] - 2*k/3);
            particles.T.xy[i] += invRho*nut*(G.xy[i] + G.yx[i]);
            particles.T.yy[i] += invRho*(2*nut*G.yy[i] - 2*k/3);
        }
    }
};

static const Turbulence::Add<Smagorinsky> add
(
    "Smagorinsky", "static Smagorinsky SPS stress, Eqs. 3-5"
);

} // namespace
} // namespace sph
