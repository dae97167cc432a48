// mu(I) as an elasto-viscoplastic solid: the exact solution of
//
//     tau = mu(I) P,   I = d gammaDot_p/sqrt(P/rhos),
//     gammaDot_p = (tau* - tau)/(G dt)                              (35)-(37)
//
// at every step. With S0 = mus P, S2 = mu2 P, A = G dt I0 sqrt(P/rhos)/d:
//
//     tau* <= S0   elastic, tau = tau*
//     otherwise    tau^2 - B tau + C = 0,
//                  B = S2 + tau* + A,  C = tau* S2 + A S0, smaller root
//
// Equation numbers: Salehizadeh & Shafiei, Granular Matter 21:32 (2019).
// Law: Jop, Forterre & Pouliquen, Nature 441, 727 (2006); return mapping after
// Dunatunga & Kamrin, J. Fluid Mech. 779, 483 (2015).
//
//     rheology  elastoViscoplasticMuI;
//     elastoViscoplasticMuICoeffs
//     {
//         mus 0.3819; mu2 0.6435; I0 0.279; d 5e-4; rhos 2500; GByK 0.5;
//     }

#include "rheology/ElastoViscoplastic.H"
#include "rheology/muIFriction.H"

#include <cmath>

namespace sph
{
namespace
{

class elastoViscoplasticMuI : public ElastoViscoplastic
{
    const muIFriction law_;

public:
    elastoViscoplasticMuI(const dictionary& dict, const EquationOfState& eos)
    :
        ElastoViscoplastic(dict, eos),
        law_(dict)
    {}

    void correct
    (
        Particles& particles, const ParticleRange& range, const scalar deltaT
    ) const override
    {
        const scalar AbySqrtP =
            G()*deltaT*law_.I0/(d()*std::sqrt(rhos()));
        integrate
        (
            particles, range, deltaT,
            [=](const lanes& tauTrial, const lanes& P)
            {
                const lanes S0 = law_.mus*P, S2 = law_.mu2*P;
                const lanes A = AbySqrtP*sqrt(P);
                const lanes B = S2 + tauTrial + A;
                const lanes C = tauTrial*S2 + A*S0;
                const lanes root =
                    sqrt(max(B*B - 4.0*C, lanes(0)));
                return select(tauTrial <= S0, tauTrial, 2.0*C/(B + root));
            }
        );
    }

    std::optional<Friction> friction(const scalar I) const override
    {
        return law_(I);
    }
};

static const Rheology::Add<elastoViscoplasticMuI> add
(
    "elastoViscoplasticMuI", "mu(I) as an elasto-viscoplastic solid; stops"
);

} // namespace
} // namespace sph
