// Ends the run when the material has come to rest: nearly all of the mass is
// slow, and neither front nor height has changed for some time.
//
//     stopWhenAtRest
//     {
//         type  stopWhenAtRest;
//         atRestFraction  0.995;  // of the mass, slower than
//         atRestSpeed     0.009;  // [m/s]; default 0.01 sqrt(|g| H0)
//         tolerance       1e-3;   // change of front and height over L0, within
//         windowByTc      0.5;    // times tc = sqrt(H0/|g|)
//         notBeforeTc     1;      // times tc: time that motion has to begin
//     }
//
// with the entries of deposit/DepositGauge.H for front, L0 and H0.

#include "deposit/DepositGauge.H"
#include "deposit/history.H"
#include "functionObjects/FunctionObject.H"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace sph
{
namespace
{

class stopWhenAtRest : public FunctionObject
{
    const Particles& particles_;
    std::unique_ptr<DepositGauge> gauge_;
    scalar fraction_;
    scalar speed_;
    scalar tolerance_;
    scalar window_;
    scalar notBefore_;
    RecentValues fronts_{0};
    RecentValues heights_{0};
    scalar nextSample_ = std::numeric_limits<scalar>::lowest();

    // A window holds this many measurements, however short the steps
    static constexpr label samplesPerWindow = 50;

public:
    stopWhenAtRest(const dictionary& dict, const word&, const Scene& scene)
    :
        particles_(scene.particles)
    {
        if (!(scene.g.norm() > 0))
        {
            dict.fail
            (
                "type", "Without gravity nothing says what is slow:"
                " stopWhenAtRest cannot be used"
            );
        }
        const auto first = readFirstState(scene.caseDir, scene.startTimeName);
        gauge_ = std::make_unique<DepositGauge>
        (
            dict, first ? *first : scene.particles, scene.rho0, scene.g
        );
        const Range positive = Range::positive();
        fraction_ = dict.getOrDefault
        (
            {"atRestFraction", "of the mass that must be slow"}, 0.995,
            dimless, Range::between(0, 1)
        );
        speed_ = dict.getOrDefault
        (
            {"atRestSpeed", "what is slow; else 0.01 sqrt(|g| H0)", "0.009"},
            0.01*std::sqrt(scene.g.norm()*gauge_->H0()), dimVelocity, positive
        );
        tolerance_ = gauge_->L0()*dict.getOrDefault
        (
            {"tolerance", "change of front and height that is none, over L0"},
            1e-3, dimless, positive
        );
        window_ = gauge_->tc()*dict.getOrDefault
        (
            {"windowByTc", "time without change, over tc = sqrt(H0/|g|)"},
            0.5, dimless, positive
        );
        notBefore_ = gauge_->tc()*dict.getOrDefault
        (
            {"notBeforeTc", "time that motion has to begin, over tc"}, 1,
            dimless, Range::nonNegative()
        );
        fronts_ = RecentValues(window_);
        heights_ = RecentValues(window_);
    }

    void execute(const scalar time, std::string& stop) override
    {
        if (time < nextSample_)
        {
            return;
        }
        nextSample_ = time + window_/samplesPerWindow;

        const Deposit deposit = gauge_->measure(particles_);
        fronts_.add(time, deposit.reach);
        heights_.add(time, deposit.height);
        const scalar slow = slowFraction();
        if
        (
            time >= notBefore_ && slow > fraction_
         && fronts_.change() < tolerance_ && heights_.change() < tolerance_
        )
        {
            std::ostringstream reason;
            reason
                << "at rest, " << 100*slow << " % of the mass slower than "
                << speed_ << " m/s, front and height unchanged for "
                << window_ << " s; run-out " << deposit.runout
                << ", height " << deposit.height << " m";
            stop = reason.str();
        }
    }

    void writeState(std::ostream& os) const override
    {
        os << "    nextSample      " << nextSample_ << ";\n";
        write(os, "fronts", fronts_);
        write(os, "heights", heights_);
    }

    void readState(const dictionary& state) override
    {
        nextSample_ = state.get<scalar>("nextSample");
        fronts_.set(state.get<std::vector<scalar>>("fronts"));
        heights_.set(state.get<std::vector<scalar>>("heights"));
    }

private:
    static void write
    (
        std::ostream& os, const word& name, const RecentValues& values
    )
    {
        os << "    " << std::left << std::setw(16) << name << '(';
        for (const scalar value : values.list())
        {
            os << ' ' << value;
        }
        os << " );\n";
    }

    scalar slowFraction() const
    {
        scalar mass = 0, slow = 0;
        const auto [begin, end] = particles_.granular();
        for (label i = begin; i < end; ++i)
        {
            mass += particles_.m[i];
            if (particles_.U[i].norm() < speed_)
            {
                slow += particles_.m[i];
            }
        }
        return slow/mass;
    }
};

static const FunctionObject::Add<stopWhenAtRest> add
(
    "stopWhenAtRest", "ends the run when the deposit has come to rest"
);

} // namespace
} // namespace sph
