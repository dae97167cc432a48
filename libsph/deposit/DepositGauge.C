#include "deposit/DepositGauge.H"

#include <cmath>
#include <limits>

namespace sph
{

// Samples of the sliding mean in its width; even, so that one lies at x = 0
static constexpr label samples = 8;


BedLine readBedLine(const dictionary& dict)
{
    const vector origin =
        dict.getVectorOrDefault
        (
            {"origin", "a point of the bed: the centre, or the back wall"},
            {0, 0}, dimLength
        );
    const vector direction =
        dict.getVectorOrDefault
        (
            {"direction", "along the bed"}, {1, 0}, dimless
        );
    if (!(direction.norm() > 0))
    {
        dict.fail("direction", "The direction of the bed must not be zero");
    }
    return {origin, direction.normalized()};
}


static scalar readThreshold(const dictionary& dict, const scalar dx)
{
    const Key threshold
    (
        "threshold", "the same in metres, in place of thresholdByDx", "1e-3"
    );
    if (!dict.found(threshold))
    {
        return dx*dict.getOrDefault
        (
            {"thresholdByDx", "thickness at the front, over the spacing"}, 0.5,
            dimless, Range::positive()
        );
    }
    if (dict.found("thresholdByDx"))
    {
        dict.fail
        (
            "thresholdByDx", "Both threshold and thresholdByDx are given:"
            " keep one of them"
        );
    }
    return dict.get("threshold", dimLength, Range::positive());
}


DepositGauge::DepositGauge
(
    const dictionary& dict, const Particles& start,
    const scalar rho0, const vector& g
)
:
    rho0_(rho0),
    bed_(readBedLine(dict)),
    startPositions_(start)
{
    const word side =
        dict.getChoiceOrDefault
        (
            {"side", "which front counts"}, "right", {"right", "left", "both"}
        );
    side_ =
        side == "right" ? Side::right
      : side == "left" ? Side::left : Side::both;

    const scalar dx = start.spacing();
    binWidth_ =
        dict.getOrDefault
        (
            {"binWidth", "bins of the profile; else 2 dx", "0.005"}, 2*dx,
            dimLength, Range::positive()
        );
    threshold_ = readThreshold(dict, dx);
    mobilisedDistance_ = dx*dict.getOrDefault
    (
        {"mobilisedByDx", "displacement that counts as one, over the spacing"},
        1, dimless, Range::positive()
    );

    const Profile profile = slidingMean(start);
    const scalar H = profile.h(profile.thickest());
    H0_ = dict.getOrDefault
    (
        {"H0", "height at the start; else measured", "0.1"}, H,
        dimLength, Range::positive()
    );
    foot_ = H - H0_ > dx ? H - H0_ : 0;
    L0_ = dict.getOrDefault
    (
        {"L0", "length at the start; else measured", "0.1"},
        reach(fronts(profile, 0.5*H)), dimLength, Range::any()
    );
    if (!(L0_ > 0))
    {
        dict.fail
        (
            "L0", "The length at the start must be greater than 0, but is "
          + std::to_string(L0_) + " m, measured from the origin to the "
          + side + ": set L0, origin or side"
        );
    }
    tc_ =
        g.norm() > 0
      ? std::sqrt(H0_/g.norm()) : std::numeric_limits<scalar>::quiet_NaN();
}


Deposit DepositGauge::measure(const Particles& particles) const
{
    Profile mean = slidingMean(particles);
    const Fronts front = fronts(mean, threshold_);
    const scalar reached = reach(front);
    const scalar height = mean.h(mean.thickest());
    const scalar atOrigin = heightAtOrigin(mean);
    return
    {
        Profile(particles, bed_, rho0_, binWidth_), std::move(mean),
        front, reached, (reached - L0_)/L0_, height, atOrigin
    };
}


scalar DepositGauge::mobilised(const Particles& particles) const
{
    return startPositions_.mobilised(particles, mobilisedDistance_);
}


scalar DepositGauge::runout
(
    const Deposit& deposit, const scalar threshold
) const
{
    return (reach(fronts(deposit.slidingMean, threshold)) - L0_)/L0_;
}


Profile DepositGauge::slidingMean(const Particles& particles) const
{
    return
        Profile(particles, bed_, rho0_, binWidth_/samples).movingMean(samples);
}


scalar DepositGauge::reach(const Fronts& front) const
{
    switch (side_)
    {
        case Side::right: return front.right;
        case Side::left: return -front.left;
        default: return 0.5*(front.right - front.left);
    }
}


scalar DepositGauge::heightAtOrigin(const Profile& mean) const
{
    // Nothing may lie behind the origin of a column that falls to one side
    const scalar half = 0.5*binWidth_;
    const scalar x =
        side_ == Side::right ? half : side_ == Side::left ? -half : 0;
    return mean.h(mean.bin(x));
}

} // namespace sph
