// Fields at points that stay where they are.
//
//     probes
//     {
//         type            probes;
//         fields          (U p s);
//         probeLocations  ((0.05 0.01 0) (0.05 0.03 0));
//         executeControl  runTime;  executeInterval 0.01;
//     }
//
// Interpolated, exact for linear fields: functionObjects/Interpolation.H; nan
// where there is no material. Writes <field>.dat, a row each call: Time and
// the components of the field at every probe, U.x_0 U.y_0 U.x_1 ...

#include "functionObjects/DataFile.H"
#include "functionObjects/FieldColumns.H"
#include "functionObjects/FunctionObject.H"
#include "functionObjects/Interpolation.H"

namespace sph
{
namespace
{

// One field, and the file that it goes to
struct ProbedField
{
    word name;
    FieldColumns columns;
    std::unique_ptr<DataFile> file;
};


class probes : public FunctionObject
{
    const Particles& particles_;
    std::vector<ProbedField> fields_;
    std::vector<vector> points_;
    OutputFolder folder_;

public:
    probes(const dictionary& dict, const word& name, const Scene& scene)
    :
        particles_(scene.particles),
        points_
        (
            dict.get<std::vector<vector>>
            ({
                "probeLocations", "points [m]", "((0.05 0.01 0) (0.05 0.03 0))"
            })
        ),
        folder_(scene.caseDir, name, scene.startTimeName)
    {
        const Key fields("fields", "fields to look at", "(U p)");
        for (const word& field : dict.get<wordList>(fields))
        {
            fields_.push_back({field, {}, nullptr});
            fields_.back().columns.add
            (
                findField(scene, field, dict, "fields")
            );
        }
        if (points_.empty())
        {
            dict.fail("probeLocations", "There must be a point to look at");
        }
        if (fields_.empty())
        {
            dict.fail("fields", "There must be a field to look at");
        }
    }

    void execute(const scalar time, std::string&) override
    {
        const Interpolation interpolation(particles_);
        for (ProbedField& field : fields_)
        {
            if (!field.file)
            {
                open(field);
            }
            std::vector<scalar> row{time};
            for (const vector& point : points_)
            {
                const auto values =
                    interpolation.at(point, field.columns.values);
                row.insert(row.end(), values.begin(), values.end());
            }
            field.file->write(row);
        }
    }

private:
    void open(ProbedField& field)
    {
        wordList comments, columns{"Time"};
        for (std::size_t k = 0; k < points_.size(); ++k)
        {
            const word number = std::to_string(k);
            comments.push_back
            (
                "Probe " + number + " (" + shortText(points_[k].x()) + ' '
              + shortText(points_[k].y()) + " 0)"
            );
            for (const word& component : field.columns.names)
            {
                columns.push_back(component + '_' + number);
            }
        }
        field.file = std::make_unique<DataFile>
        (
            folder_.path()/(field.name + ".dat"), comments, columns
        );
    }
};

static const FunctionObject::Add<probes> add
(
    "probes", "fields at points, a row each time"
);

} // namespace
} // namespace sph
