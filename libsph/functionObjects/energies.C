// Energies, momentum and mass of the granular material, per unit depth.
//
//     energies { type energies; executeInterval 20; }
//
// The potential energy counts from the first time of the case, after a restart
// too; dissipated is what the sum has lost since. The elastic energy is the
// work of compression from rho0, V p^2/(2K) for the linear law.

#include "deposit/Energies.H"
#include "deposit/StartState.H"
#include "functionObjects/DataFile.H"
#include "functionObjects/FunctionObject.H"

namespace sph
{
namespace
{

static Energies startEnergies(const Scene& scene)
{
    const auto first = readFirstState(scene.caseDir, scene.startTimeName);
    return {first ? *first : scene.particles, scene.g, scene.rho0};
}


class energies : public FunctionObject
{
    const Scene scene_;
    const Energies start_;
    word name_;
    OutputFolder folder_;
    std::unique_ptr<DataFile> file_;

public:
    energies(const dictionary& dict, const word& name, const Scene& scene)
    :
        scene_(scene),
        start_(startEnergies(scene)),
        name_(name),
        folder_(scene.caseDir, name, scene.startTimeName)
    {
        findField(scene, "p", dict, "type");
    }

    void execute(const scalar time, std::string&) override
    {
        const Energies now(scene_.particles, scene_.g, scene_.rho0);
        if (!file_)
        {
            open();
        }
        file_->write
        ({
            time, now.kinetic, now.potential - start_.potential, now.elastic,
            start_.total() - now.total(), now.mass,
            now.momentum.x(), now.momentum.y(),
            now.centreOfMass.x(), now.centreOfMass.y()
        });
    }

private:
    void open()
    {
        file_ = std::make_unique<DataFile>
        (
            folder_.path()/(name_ + ".dat"),
            wordList
            {
                "per unit depth: energies [J/m], mass [kg/m],"
                " momentum [kg/s], centre of mass [m]"
            },
            wordList
            {
                "Time", "kinetic", "potential", "elastic", "dissipated",
                "mass", "momentumX", "momentumY", "centreX", "centreY"
            }
        );
    }
};

static const FunctionObject::Add<energies> add
(
    "energies", "kinetic, potential, elastic energy, momentum and mass"
);

} // namespace
} // namespace sph
