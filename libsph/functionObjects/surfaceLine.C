// The free surface y(x) of the material over its bed.
//
//     surfaceLine
//     {
//         type       surfaceLine;
//         origin     (0 0 0);          // default; a point of the bed
//         direction  (1 0 0);          // default; along the bed
//         binWidth   0.0049;           // [m]; default 2 dx
//         executeControl writeTime;    // default
//     }
//
// The surface lies as far above the bed, normal to it, as the material of a
// bin would fill it at the density rho0: deposit/Profile.H. Writes
// surface_<time>.dat, a row each bin: the place x, y of the surface, the
// distance s along the bed from the origin, and the thickness h [m].

#include "deposit/DepositGauge.H"
#include "functionObjects/DataFile.H"
#include "functionObjects/FunctionObject.H"

namespace sph
{
namespace
{

class surfaceLine : public FunctionObject
{
    const Particles& particles_;
    scalar rho0_;
    BedLine bed_;
    scalar binWidth_;
    OutputFolder folder_;

public:
    surfaceLine(const dictionary& dict, const word& name, const Scene& scene)
    :
        particles_(scene.particles),
        rho0_(scene.rho0),
        bed_(readBedLine(dict)),
        binWidth_
        (
            dict.getOrDefault
            (
                {"binWidth", "bins of the profile; else 2 dx", "0.005"},
                2*particles_.spacing(), dimLength, Range::positive()
            )
        ),
        folder_(scene.caseDir, name, scene.startTimeName)
    {}

    const char* defaultControl() const override { return "writeTime"; }

    void execute(const scalar time, std::string&) override
    {
        const Profile profile(particles_, bed_, rho0_, binWidth_);
        const vector along = bed_.direction, up(-along.y(), along.x());
        const word t = shortText(time);
        DataFile file
        (
            folder_.path()/("surface_" + t + ".dat"),
            {"Time [s] " + t + "; lengths [m]"}, {"x", "y", "s", "h"}
        );
        for (label bin = 0; bin < profile.size(); ++bin)
        {
            const scalar s = profile.x(bin), h = profile.h(bin);
            const vector place = bed_.origin + s*along + h*up;
            file.write({place.x(), place.y(), s, h});
        }
    }
};

static const FunctionObject::Add<surfaceLine> add
(
    "surfaceLine", "free surface y(x) of a deposit, a file each time"
);

} // namespace
} // namespace sph
