// Fields at points along lines.
//
//     sets
//     {
//         type    sets;
//         fields  (U p);
//         sets
//         {
//             middle
//             {
//                 type     uniform;    // default: evenly, both ends included
//                 start    (0.05 0 0);
//                 end      (0.05 0.1 0);
//                 nPoints  21;
//             }
//         }
//         executeControl writeTime;    // default
//     }
//
// Interpolated, exact for linear fields: functionObjects/Interpolation.H; nan
// where there is no material. Writes <set>_<time>.dat: distance from the start
// [m], x, y and the components of the fields.

#include "functionObjects/DataFile.H"
#include "functionObjects/FieldColumns.H"
#include "functionObjects/FunctionObject.H"
#include "functionObjects/Interpolation.H"

namespace sph
{
namespace
{

struct SampledLine
{
    word name;
    vector start;
    vector end;
    label nPoints;

    SampledLine(const word& name, const dictionary& dict)
    :
        name(name),
        start(dict.getVector({"start", "first point"}, dimLength)),
        end(dict.getVector({"end", "last point"}, dimLength)),
        nPoints
        (
            dict.getLabel({"nPoints", "number of points"}, Range{2})
        )
    {
        dict.getChoiceOrDefault
        (
            {"type", "spacing of the points"}, "uniform", {"uniform"}
        );
        if (start == end)
        {
            dict.fail("end", "The line begins where it ends");
        }
    }

    vector point(const label k) const
    {
        return start + scalar(k)/(nPoints - 1)*(end - start);
    }
};


class sets : public FunctionObject
{
    const Particles& particles_;
    FieldColumns columns_;
    std::vector<SampledLine> lines_;
    OutputFolder folder_;

public:
    sets(const dictionary& dict, const word& name, const Scene& scene)
    :
        particles_(scene.particles),
        folder_(scene.caseDir, name, scene.startTimeName)
    {
        const Key fields("fields", "fields to look at", "(U p)");
        for (const word& field : dict.get<wordList>(fields))
        {
            columns_.add(findField(scene, field, dict, "fields"));
        }
        const dictionary& lines = dict.subDict
        ({
            "sets", "lines, each with a name",
            "{ middle { start (0.05 0 0); end (0.05 0.1 0); nPoints 21; } }"
        });
        for (const word& line : lines.toc())
        {
            lines_.emplace_back(line, lines.subDict(line));
        }
        if (lines_.empty())
        {
            dict.fail("sets", "There must be a line to look along");
        }
    }

    const char* defaultControl() const override { return "writeTime"; }

    void execute(const scalar time, std::string&) override
    {
        const Interpolation interpolation(particles_);
        for (const SampledLine& line : lines_)
        {
            write(line, interpolation, time);
        }
    }

private:
    void write
    (
        const SampledLine& line, const Interpolation& interpolation,
        const scalar time
    )
    {
        wordList names{"distance", "x", "y"};
        names.insert
        (
            names.end(), columns_.names.begin(), columns_.names.end()
        );
        const word t = shortText(time);
        DataFile file
        (
            folder_.path()/(line.name + '_' + t + ".dat"),
            {"Time [s] " + t + "; SI units"}, names
        );
        for (label k = 0; k < line.nPoints; ++k)
        {
            const vector x = line.point(k);
            std::vector<scalar> row{(x - line.start).norm(), x.x(), x.y()};
            const auto values = interpolation.at(x, columns_.values);
            row.insert(row.end(), values.begin(), values.end());
            file.write(row);
        }
    }
};

static const FunctionObject::Add<sets> add
(
    "sets", "fields along lines, a file each time"
);

} // namespace
} // namespace sph
