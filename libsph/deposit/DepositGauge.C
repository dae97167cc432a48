#include "deposit/DepositGauge.H"

#include <cmath>
#include <limits>

namespace sph
{

static BedLine readBed(const dictionary& dict)
{
    const vector origin =
        dict.getVectorOrDefault("origin", {0, 0}, dimLength);
    const vector direction =
        dict.getVectorOrDefault("direction", {1, 0}, dimless);
    if (!(direction.norm() > 0))
    {
        dict.fail("direction", "The direction of the bed must not be zero");
    }
    return {origin, direction.normalized()};
}


static scalar readThreshold(const dictionary& dict, const scalar dx)
{
    if (!dict.found("threshold"))
    {
        return dx*dict.getOrDefault
        (
            "thresholdByDx", 1, dimless, Range::positive()
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
    bed_(readBed(dict)),
    startPositions_(start)
{
    const word side =
        dict.getChoiceOrDefault("side", "right", {"right", "left", "both"});
    side_ =
        side == "right" ? Side::right
      : side == "left" ? Side::left : Side::both;

    const scalar dx = start.spacing();
    binWidth_ =
        dict.getOrDefault("binWidth", 2*dx, dimLength, Range::positive());
    threshold_ = readThreshold(dict, dx);
    mobilisedDistance_ = dx*dict.getOrDefault
    (
        "mobilisedByDx", 1, dimless, Range::positive()
    );

    const Profile profile(start, bed_, rho0, binWidth_);
    const scalar H = profile.h(profile.thickest());
    H0_ = dict.getOrDefault("H0", H, dimLength, Range::positive());
    L0_ = dict.getOrDefault
    (
        "L0", reach(fronts(profile, 0.5*H)), dimLength, Range::any()
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
    Profile profile(particles, bed_, rho0_, binWidth_);
    const Fronts front = fronts(profile, threshold_);
    const scalar reached = reach(front);
    const scalar height = profile.h(profile.thickest());
    const scalar atOrigin = heightAtOrigin(profile);
    return
    {
        std::move(profile), front, reached, (reached - L0_)/L0_,
        height, atOrigin
    };
}


scalar DepositGauge::mobilised(const Particles& particles) const
{
    return startPositions_.mobilised(particles, mobilisedDistance_);
}


scalar DepositGauge::runout
(
    const Profile& profile, const scalar threshold
) const
{
    return (reach(fronts(profile, threshold)) - L0_)/L0_;
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


scalar DepositGauge::heightAtOrigin(const Profile& profile) const
{
    // An edge between bins lies at the origin
    const label right = profile.bin(0.5*profile.binWidth());
    switch (side_)
    {
        case Side::right: return profile.h(right);
        case Side::left: return profile.h(right - 1);
        default: return 0.5*(profile.h(right - 1) + profile.h(right));
    }
}

} // namespace sph
