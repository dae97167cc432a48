#include "rheology/WellPosedFriction.H"

#include <algorithm>
#include <cmath>

namespace sph
{

// Where C of mu(I) changes its sign from + to -, going up; 0 if nowhere
static scalar lowerBound(const muIFriction& law)
{
    const auto C = [&](const scalar I)
    {
        return law(I).C();
    };
    constexpr scalar factor = 1.02;
    scalar high = 1e-8*law.I0;
    while (C(high) > 0)
    {
        high *= factor;
        if (high > 1e3*law.I0)
        {
            return 0;
        }
    }
    scalar low = high/factor;
    for (label k = 0; k < 60; ++k)
    {
        const scalar middle = 0.5*(low + high);
        (C(middle) > 0 ? low : high) = middle;
    }
    return high;
}

WellPosedFriction::WellPosedFriction(const dictionary& dict)
:
    law_(dict, Range::positive()),
    muInf_
    (
        dict.getOrDefault
        (
            {"muInf", "rise of the friction with I in fast flow"}, 0.05,
            dimless, Range::nonNegative()
        )
    ),
    alpha_
    (
        dict.getOrDefault
        (
            {"alpha", "of the friction near rest, sqrt(alpha/log(A/I))"}, 1.9,
            dimless, Range::between(0.1, 2)
        )
    )
{
    I1_ = lowerBound(law_);
    if (I1_ == 0)
    {
        dict.fail
        (
            "mus", "With these mus, mu2 and I0, mu(I) is ill-posed everywhere:"
            " there is nothing to go on from"
        );
    }
    mu1_ = above(I1_);
    A_ = I1_*std::exp(alpha_/(mu1_*mu1_));
}

scalar WellPosedFriction::above(const scalar I) const
{
    return (law_.mus*law_.I0 + (law_.mu2 + muInf_*I)*I)/(law_.I0 + I);
}

scalar WellPosedFriction::mu(const scalar I) const
{
    return
        I > I1_ ? above(I)
      : I > 0 ? std::sqrt(alpha_/std::log(A_/I))
      : 0;
}

Friction WellPosedFriction::friction(const scalar I) const
{
    const scalar mu = this->mu(I);
    if (I <= I1_)
    {
        return {mu, mu*mu/(2*alpha_)};
    }
    const scalar slope =
        ((law_.mu2 - law_.mus)*law_.I0 + muInf_*I*(2*law_.I0 + I))
       /((law_.I0 + I)*(law_.I0 + I));
    return {mu, I*slope/mu};
}

scalar WellPosedFriction::solve
(
    const scalar a, const scalar P, const scalar tau
) const
{
    if (tau > a*I1_ + P*mu1_)
    {
        // (a + P muInf) I^2 + B I = C
        const scalar B = a*law_.I0 + P*law_.mu2 - tau;
        const scalar C = (tau - P*law_.mus)*law_.I0;
        const scalar root = std::sqrt(B*B + 4*(a + P*muInf_)*C);
        return above(B > 0 ? 2*C/(B + root) : (root - B)/(2*(a + P*muInf_)));
    }
    // a A exp(-alpha/mu^2) + P mu = tau, convex: Newton's method from above,
    // from where one of the terms alone is tau
    scalar mu = std::min(tau/P, mu1_);
    if (a*A_ > tau)
    {
        mu = std::min(mu, std::sqrt(alpha_/std::log(a*A_/tau)));
    }
    for (label iteration = 0; iteration < 50; ++iteration)
    {
        const scalar invMuSqr = 1/(mu*mu);
        const scalar aI = a*A_*std::exp(-alpha_*invMuSqr);
        const scalar step =
            (aI + P*mu - tau)/(2*alpha_*aI*invMuSqr/mu + P);
        mu -= step;
        if (std::abs(step) <= 1e-14*mu)
        {
            break;
        }
    }
    return mu;
}

} // namespace sph
