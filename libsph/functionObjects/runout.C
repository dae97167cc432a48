// Front, run-out and height of a collapsing column while it runs.
//
//     runout
//     {
//         type  runout;   executeInterval 20;
//         origin (0 0 0); side right; L0 0.0972; H0 0.0875;
//         profileInterval 0;      // h(x) at every n-th call; 0: never
//     }
//
// All entries of the measurement: deposit/DepositGauge.H. Without L0 and H0
// the first time of the case is the start, after a restart too.

#include "deposit/DepositGauge.H"
#include "functionObjects/DataFile.H"
#include "functionObjects/FunctionObject.H"

namespace sph
{
namespace
{

static DepositGauge gaugeOf(const dictionary& dict, const Scene& scene)
{
    const auto first = readFirstState(scene.caseDir, scene.startTimeName);
    return
    {
        dict, first ? *first : scene.particles, scene.rho0, scene.g
    };
}


class runout : public FunctionObject
{
    const Particles& particles_;
    DepositGauge gauge_;
    label profileInterval_;
    word name_;
    OutputFolder folder_;
    std::unique_ptr<DataFile> file_;
    label calls_ = 0;

public:
    runout(const dictionary& dict, const word& name, const Scene& scene)
    :
        particles_(scene.particles),
        gauge_(gaugeOf(dict, scene)),
        profileInterval_
        (
            dict.getLabelOrDefault
            (
                {"profileInterval", "calls between profiles h(x); 0: never"},
                0, Range{0}
            )
        ),
        name_(name),
        folder_(scene.caseDir, name, scene.startTimeName)
    {}

    void execute(const scalar time, std::string&) override
    {
        const Deposit deposit = gauge_.measure(particles_);
        if (!file_)
        {
            open();
        }
        file_->write
        ({
            time, time/gauge_.tc(), deposit.front.left, deposit.front.right,
            deposit.runout, deposit.height, deposit.heightAtOrigin,
            gauge_.mobilised(particles_)
        });
        if (profileInterval_ > 0 && calls_ % profileInterval_ == 0)
        {
            writeProfile(deposit.profile, time);
        }
        ++calls_;
    }

    void writeState(std::ostream& os) const override
    {
        os << "    calls           " << calls_ << ";\n";
    }

    void readState(const dictionary& state) override
    {
        calls_ = state.get<label>("calls");
    }

private:
    void open()
    {
        file_ = std::make_unique<DataFile>
        (
            folder_.path()/(name_ + ".dat"),
            wordList
            {
                "L0 [m] " + shortText(gauge_.L0()) + "  H0 [m] "
              + shortText(gauge_.H0()) + "  threshold [m] "
              + shortText(gauge_.threshold()),
                "Time [s], fronts and heights [m] from the origin"
            },
            wordList
            {
                "Time", "t/tc", "frontLeft", "frontRight", "runout",
                "height", "heightAtOrigin", "mobilised"
            }
        );
    }

    void writeProfile(const Profile& profile, const scalar time)
    {
        DataFile file
        (
            folder_.path()/("profile_" + shortText(time) + ".dat"),
            {"Time [s] " + shortText(time)}, {"x", "h"}
        );
        for (label bin = 0; bin < profile.size(); ++bin)
        {
            file.write({profile.x(bin), profile.h(bin)});
        }
    }
};

static const FunctionObject::Add<runout> add
(
    "runout", "front, run-out, height and surface profile of a deposit"
);

} // namespace
} // namespace sph
