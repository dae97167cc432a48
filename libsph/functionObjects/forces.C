// Force of the material on walls, and its moment, per metre depth.
//
//     forces
//     {
//         type     forces;
//         patches  (bed side);     // names of constant/boundary, summed
//         CofR     (0 0 0);        // default; centre of the moment [m]
//         executeInterval 20;
//     }
//
// From the pair sums that the material feels: scheme/WallForces.H. Writes
// <name>.dat, a row each call: the force, its part by pressure and the rest,
// shear [N/m], and the moment about CofR, anticlockwise [N]. After a restart
// the first row is that of the first step. Material that sleeps pushes as it
// did when it fell asleep.

#include "functionObjects/DataFile.H"
#include "functionObjects/FunctionObject.H"
#include "scheme/WallForces.H"

namespace sph
{
namespace
{

class forces : public FunctionObject
{
    const WallForces& wallForces_;
    std::vector<label> patches_;
    wordList names_;
    vector centre_;
    word name_;
    OutputFolder folder_;
    std::unique_ptr<DataFile> file_;

    static WallForces& watched(const dictionary& dict, const Scene& scene)
    {
        if (!scene.wallForces)
        {
            dict.fail
            (
                "type", "Forces on walls are made of pairs of particles, which"
                " are in no file: only a run has them\n\n"
                "-func NAME executes one that can do without"
            );
        }
        if (!scene.wallForces->refusal().empty())
        {
            dict.fail("type", scene.wallForces->refusal());
        }
        scene.wallForces->watch();
        return *scene.wallForces;
    }

public:
    forces(const dictionary& dict, const word& name, const Scene& scene)
    :
        wallForces_(watched(dict, scene)),
        names_
        (
            dict.get<wordList>
            (
                {"patches", "walls of constant/boundary, summed", "(bed)"}
            )
        ),
        centre_
        (
            dict.getVectorOrDefault
            (
                {"CofR", "centre of the moment"}, vector::Zero(), dimLength
            )
        ),
        name_(name),
        folder_(scene.caseDir, name, scene.startTimeName)
    {
        const auto& walls = wallForces_.walls();
        wordList valid;
        for (const auto& [wall, index] : walls)
        {
            valid.push_back(wall);
        }
        for (const word& patch : names_)
        {
            const auto found = walls.find(patch);
            if (found == walls.end())
            {
                dict.fail
                (
                    "patches", "Unknown wall " + patch + "\n\nValid walls :\n\n"
                  + listOfWords(valid)
                );
            }
            patches_.push_back(found->second);
        }
    }

    void execute(const scalar time, std::string&) override
    {
        if (!wallForces_.known())
        {
            return;
        }
        if (!file_)
        {
            open();
        }
        const WallForces::Force force = wallForces_.on(patches_, centre_);
        const vector total = force.total();
        file_->write
        ({
            time, total.x(), total.y(), force.pressure.x(), force.pressure.y(),
            force.shear.x(), force.shear.y(), force.moment
        });
    }

private:
    void open()
    {
        word list;
        for (const word& name : names_)
        {
            list += ' ' + name;
        }
        file_ = std::make_unique<DataFile>
        (
            folder_.path()/(name_ + ".dat"),
            wordList
            {
                "Walls:" + list + "; per metre depth: forces [N/m], moment [N]"
                " about (" + shortText(centre_.x()) + ' '
              + shortText(centre_.y()) + " 0)"
            },
            wordList
            {
                "Time", "Fx", "Fy", "pressureX", "pressureY", "shearX",
                "shearY", "Mz"
            }
        );
    }
};

static const FunctionObject::Add<forces> add
(
    "forces", "force and moment of the material on walls"
);

} // namespace
} // namespace sph
