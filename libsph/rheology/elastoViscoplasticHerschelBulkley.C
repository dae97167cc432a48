// Herschel-Bulkley fluid, or Bingham plastic (n 1), as an elasto-viscoplastic
// solid: the exact solution of
//
//     tau = tau0 + k x^n,   x = (tau* - tau)/(G dt)
//
// at every step, x the plastic part of the shear rate. tau = tau* below tau0:
// it stops, and there is no viscous limit on the time step. k in Pa s^n.
// Saramito, J. Non-Newton. Fluid Mech. 158, 154 (2009), without viscosity of
// the solvent.
//
//     rheology  elastoViscoplasticHerschelBulkley;
//     elastoViscoplasticHerschelBulkleyCoeffs
//     {
//         tau0 20;  k 0.5;  n 0.6;  GByK 0.5;
//     }

#include "rheology/ReturnMapping.H"

#include <cmath>

namespace sph
{
namespace
{

class elastoViscoplasticHerschelBulkley : public ReturnMapping
{
    const scalar tau0_, k_, n_;

    // G dt x + k x^n = excess > 0, where G dt x > 0 is sought: by Newton's
    // method from the side from which it converges without overshooting
    scalar elasticLoss(const scalar excess, const scalar GDeltaT) const
    {
        if (n_ == 1)
        {
            return excess*GDeltaT/(GDeltaT + k_);
        }
        const scalar share = n_ < 1 ? 0.5 : 1;
        scalar x = std::min
        (
            share*excess/GDeltaT, std::pow(share*excess/k_, 1/n_)
        );
        for (label iteration = 0; iteration < 50; ++iteration)
        {
            const scalar flow = k_*std::pow(x, n_);
            const scalar step =
                (excess - GDeltaT*x - flow)/(GDeltaT + n_*flow/x);
            x += step;
            if (std::abs(step) <= 1e-13*x)
            {
                break;
            }
        }
        return GDeltaT*x;
    }

public:
    elastoViscoplasticHerschelBulkley
    (
        const dictionary& dict, const EquationOfState& eos
    )
    :
        ReturnMapping(dict, eos),
        tau0_
        (
            dict.get
            (
                {"tau0", "yield stress", "20"},
                dimPressure, Range::nonNegative()
            )
        ),
        k_(dict.get<scalar>({"k", "consistency [Pa s^n]", "0.5"})),
        n_
        (
            dict.getOrDefault
            (
                {"n", "power of the rate; 1: Bingham"}, 1,
                dimless, Range::between(0.1, 5)
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
        Particles& particles, const ParticleRange& range, const scalar deltaT
    ) const override
    {
        const scalar GDeltaT = G()*deltaT;
        mapBack
        (
            particles, range, deltaT,
            [=](const ParticleValues<lanes>&, const lanes& tauTrial)
            {
                return lanes([&](const auto lane)
                {
                    const scalar trial = tauTrial[lane];
                    const scalar excess = trial - tau0_;
                    return excess > small
                      ? trial - elasticLoss(excess, GDeltaT) : trial;
                });
            }
        );
    }
};

static const Rheology::Add<elastoViscoplasticHerschelBulkley> add
(
    "elastoViscoplasticHerschelBulkley",
    "Herschel-Bulkley or Bingham as an elasto-viscoplastic solid; stops"
);

} // namespace
} // namespace sph
