// Local mu(I) rheology as a generalised Newtonian fluid.
//
//     I     = d gammaDot/sqrt(P/rhos)                                   (35)
//     mu(I) = mus + (mu2 - mus)/(1 + I0/I)                              (36)
//     eta   = mu(I) P/gammaDot
//           = mus P/gammaDot + (mu2 - mus) P/(gammaDot + xi sqrt(P)),
//     xi    = I0/(d sqrt(rhos))                                    (37)-(38)
//
// with one of two regularisations of the first term, infinite at rest:
//
//     cap            eta <= etaMax
//     Papanastasiou  mus P (1 - exp(-gammaDot/alphar))/gammaDot         (39)
//                  + (mu2 - mus) P/(xi sqrt(P) + gammaDot)
//                    gammaDot/sqrt(gammaDot^2 + alphas^2)
//
// Either creeps: a heap never quite stops; alphar = 0.01 1/s as printed makes
// time steps of 1e-9 s. For heaps that stop: elastoViscoplasticMuI.
//
// Equation numbers: Salehizadeh & Shafiei, Granular Matter 21:32 (2019).
// Law: Jop, Forterre & Pouliquen, Nature 441, 727 (2006).
//
//     rheology  muI;
//     muICoeffs
//     {
//         mus 0.3819; mu2 0.6435; I0 0.279; d 5e-4; rhos 2500;
//         regularisation cap;            etaMax 20;
//     //  regularisation Papanastasiou;  alphar 0.01;  alphas 1e-6;
//     }

#include "rheology/GeneralisedNewtonian.H"
#include "rheology/Grains.H"
#include "rheology/muIFriction.H"

#include <cmath>

namespace sph
{
namespace
{

class muI : public GeneralisedNewtonian
{
    const muIFriction law_;
    const Grains grains_;
    const bool cap_;
    const scalar etaMax_;
    const scalar alphar_, alphas_;
    const scalar xi_;

public:
    muI(const dictionary& dict, const EquationOfState&)
    :
        law_(dict),
        grains_(dict),
        cap_
        (
            dict.getChoice
            (
                {"regularisation", "what bounds the viscosity at rest", "cap"},
                {"cap", "Papanastasiou"}
            )
         == "cap"
        ),
        etaMax_
        (
            cap_
          ? dict.get
            (
                {"etaMax", "greatest viscosity", "20"},
                dimDynamicViscosity, Range::positive()
            )
          : 0
        ),
        alphar_
        (
            cap_ ? 0
          : dict.getOrDefault
            (
                {"alphar", "shear rate below which friction fades, Eq. 39"},
                0.01, dimRate, Range::positive()
            )
        ),
        alphas_
        (
            cap_ ? 0
          : dict.getOrDefault
            (
                {"alphas", "the same of its second term"},
                1e-6, dimRate, Range::nonNegative()
            )
        ),
        xi_(law_.I0/(grains_.d*std::sqrt(grains_.rhos)))
    {}

    void correct
    (
        Particles& particles, const ParticleRange& range, scalar
    ) const override
    {
        for (label i = range.begin; i < range.end; ++i)
        {
            const scalar P = std::max(particles.p[i] + particles.q[i], 0.0);
            const scalar gammaDot = particles.gammaDot[i];
            particles.eta[i] =
                P == 0 ? 0
              : cap_ ? cappedViscosity(P, gammaDot)
              : PapanastasiouViscosity(P, gammaDot);
            particles.I[i] =
                P == 0 ? 0 : grains_.d*gammaDot/std::sqrt(P/grains_.rhos);
            setStress(particles, i);
        }
    }

    std::optional<Friction> friction(const scalar I) const override
    {
        return law_(I);
    }

private:
    // (38), at most etaMax
    scalar cappedViscosity(const scalar P, const scalar gammaDot) const
    {
        const scalar yield = law_.mus*P;
        const scalar flow =
            (law_.mu2 - law_.mus)*P/(gammaDot + xi_*std::sqrt(P));
        return
            yield + flow*gammaDot >= etaMax_*gammaDot
          ? etaMax_ : yield/gammaDot + flow;
    }

    // (39)
    scalar PapanastasiouViscosity(const scalar P, const scalar gammaDot) const
    {
        const scalar x = gammaDot/alphar_;
        const scalar yield =
            law_.mus*P/alphar_*(x > 1e-8 ? -std::expm1(-x)/x : 1);
        const scalar flow =
            (law_.mu2 - law_.mus)*P/(xi_*std::sqrt(P) + gammaDot);
        const scalar norm =
            std::sqrt(gammaDot*gammaDot + alphas_*alphas_);
        return yield + (norm > 0 ? flow*gammaDot/norm : flow);
    }
};

static const Rheology::Add<muI> add
(
    "muI", "local mu(I) law as a generalised Newtonian fluid, Eqs. 35-39"
);

} // namespace
} // namespace sph
