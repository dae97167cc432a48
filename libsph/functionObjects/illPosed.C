// Marks where the local law is ill-posed: the field illPosed, the condition C
// of Barker et al. (see rheology/Rheology.H) from mu(I) at every particle, is
// greater than 0 there, and 0 where nothing flows.
//
//     illPosed { type illPosed; }
//
// It is written with the particles, and shown by ParaView. Writes <name>.dat, a
// row each call: the share of the mass that flows (I > 0), and that which flows
// where the law is ill-posed. Calls are at write times unless executeControl
// says so.

#include "functionObjects/DataFile.H"
#include "functionObjects/FunctionObject.H"
#include "rheology/Rheology.H"

namespace sph
{
namespace
{

class illPosed : public FunctionObject
{
    Particles& particles_;
    const Rheology& rheology_;
    word name_;
    OutputFolder folder_;
    std::unique_ptr<DataFile> file_;

    static const Rheology& checked(const dictionary& dict, const Scene& scene)
    {
        if (!scene.rheology || !scene.rheology->friction(0))
        {
            dict.fail
            (
                "type", "The rheology of this case has no mu(I) that could be"
                " ill-posed"
            );
        }
        findField(scene, "I", dict, "type");
        return *scene.rheology;
    }

public:
    illPosed(const dictionary& dict, const word& name, const Scene& scene)
    :
        particles_(scene.particles),
        rheology_(checked(dict, scene)),
        name_(name),
        folder_(scene.caseDir, name, scene.startTimeName)
    {
        particles_.use("illPosed");
    }

    const char* defaultControl() const override { return "writeTime"; }

    void execute(const scalar time, std::string&) override
    {
        scalar mass = 0, flowing = 0, marked = 0;
        const ParticleRange range = particles_.granular();
        for (label i = range.begin; i < range.end; ++i)
        {
            const scalar I = particles_.I[i], m = particles_.m[i];
            const scalar C = I > 0 ? rheology_.friction(I)->C() : 0;
            particles_.illPosed[i] = C;
            mass += m;
            flowing += I > 0 ? m : 0;
            marked += C > 0 ? m : 0;
        }
        if (!file_)
        {
            file_ = std::make_unique<DataFile>
            (
                folder_.path()/(name_ + ".dat"),
                wordList{"Time [s]; shares of the mass"},
                wordList{"Time", "flowing", "illPosed"}
            );
        }
        file_->write({time, flowing/mass, marked/mass});
    }
};

static const FunctionObject::Add<illPosed> add
(
    "illPosed", "marks where mu(I) is ill-posed"
);

} // namespace
} // namespace sph
