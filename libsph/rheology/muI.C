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
#include "rheology/muIFriction.H"

#include <cmath>

namespace sph
{
namespace
{

class muI : public GeneralisedNewtonian
{
    const scalar mus_, mu2_, I0_, d_, rhos_;
    const bool cap_;
    const scalar etaMax_;
    const scalar alphar_, alphas_;
    const scalar xi_;

public:
    muI(const dictionary& dict, const EquationOfState&)
    :
        mus_
        (
            dict.get
            (
                {"mus", "friction coefficient of slow flow", "0.3819"},
                dimless, Range::nonNegative()
            )
        ),
        mu2_
        (
            dict.get
            (
                {"mu2", "friction coefficient of fast flow", "0.6435"},
                dimless, Range::nonNegative()
            )
        ),
        I0_
        (
            dict.get
            (
                {"I0", "inertial number between slow and fast", "0.279"},
                dimless, Range::positive()
            )
        ),
        d_
        (
            dict.get
            (
                {"d", "diameter of a grain", "5e-4"},
                dimLength, Range::positive()
            )
        ),
        rhos_
        (
            dict.get
            (
                {"rhos", "density of a grain", "2500"},
                dimDensity, Range::positive()
            )
        ),
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
        xi_(I0_/(d_*std::sqrt(rhos_)))
    {
        if (mu2_ < mus_)
        {
            dict.fail("mu2", "mu2 must be at least mus");
        }
    }

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
            particles.I[i] = P == 0 ? 0 : d_*gammaDot/std::sqrt(P/rhos_);
            setStress(particles, i);
        }
    }

    std::optional<Friction> friction(const scalar I) const override
    {
        return muIFriction(mus_, mu2_, I0_, I);
    }

private:
    // (38), at most etaMax
    scalar cappedViscosity(const scalar P, const scalar gammaDot) const
    {
        const scalar yield = mus_*P;
        const scalar flow =
            (mu2_ - mus_)*P/(gammaDot + xi_*std::sqrt(P));
        return
            yield + flow*gammaDot >= etaMax_*gammaDot
          ? etaMax_ : yield/gammaDot + flow;
    }

    // (39)
    scalar PapanastasiouViscosity(const scalar P, const scalar gammaDot) const
    {
        const scalar x = gammaDot/alphar_;
        const scalar yield =
            mus_*P/alphar_*(x > 1e-8 ? -std::expm1(-x)/x : 1);
        const scalar flow = (mu2_ - mus_)*P/(xi_*std::sqrt(P) + gammaDot);
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
