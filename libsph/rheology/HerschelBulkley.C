// Herschel-Bulkley fluid as a generalised Newtonian fluid, regularised:
//
//     tau = tau0 + k gammaDot^n,
//     eta = tau0/gammaDot + k (gammaDot^2 + alphas^2)^((n - 1)/2)
//
// k in Pa s^n. alphas keeps the second term finite at rest. For one that stops
// below yield: elastoViscoplasticHerschelBulkley.
// Herschel & Bulkley, Kolloid-Zeitschrift 39, 291 (1926).
//
//     rheology  HerschelBulkley;
//     HerschelBulkleyCoeffs
//     {
//         tau0 20;  k 0.5;  n 0.6;  alphas 1e-6;
//         regularisation Papanastasiou;  alphar 0.1;
//     //  regularisation cap;            etaMax 50;
//     }

#include "rheology/YieldStress.H"

namespace sph
{
namespace
{

class HerschelBulkley : public YieldStress
{
    const scalar k_, n_, alphas_;

public:
    HerschelBulkley(const dictionary& dict, const EquationOfState&)
    :
        YieldStress(dict),
        k_(dict.get<scalar>({"k", "consistency [Pa s^n]", "0.5"})),
        n_
        (
            dict.get
            (
                {"n", "power of the rate", "0.6"},
                dimless, Range::between(0.1, 5)
            )
        ),
        alphas_
        (
            dict.getOrDefault
            (
                {"alphas", "rate that keeps the power finite at rest"}, 1e-6,
                dimRate, Range::positive()
            )
        )
    {
        if (k_ < 0)
        {
            dict.fail("k", "k must be at least 0");
        }
    }

    void correct
    (
        Particles& particles, const ParticleRange& range, scalar
    ) const override
    {
        setViscosity
        (
            particles, range,
            [=](const scalar gammaDot)
            {
                const scalar rateSqr = gammaDot*gammaDot + alphas_*alphas_;
                return k_*std::pow(rateSqr, 0.5*(n_ - 1));
            }
        );
    }
};

static const Rheology::Add<HerschelBulkley> add
(
    "HerschelBulkley", "yield stress and a power of the rate, regularised"
);

} // namespace
} // namespace sph
