// Least and greatest value of fields of the granular particles, and where.
//
//     fieldMinMax { type fieldMinMax; fields (U p rho); executeInterval 20; }
//
// Vectors and tensors count by their magnitude (deposit/magnitude.H).

#include "deposit/magnitude.H"
#include "functionObjects/DataFile.H"
#include "functionObjects/FunctionObject.H"

namespace sph
{
namespace
{

class fieldMinMax : public FunctionObject
{
    const Particles& particles_;
    std::vector<const FieldInfo*> fields_;
    word name_;
    OutputFolder folder_;
    std::unique_ptr<DataFile> file_;

public:
    fieldMinMax(const dictionary& dict, const word& name, const Scene& scene)
    :
        particles_(scene.particles),
        name_(name),
        folder_(scene.caseDir, name, scene.startTimeName)
    {
        const Key fields("fields", "fields to look at", "(U p)");
        for (const word& field : dict.get<wordList>(fields))
        {
            fields_.push_back(&findField(scene, field, dict, "fields"));
        }
    }

    void execute(const scalar time, std::string&) override
    {
        if (!file_)
        {
            open();
        }
        std::vector<scalar> row{time};
        for (const FieldInfo* field : fields_)
        {
            appendExtremes(*field, row);
        }
        file_->write(row);
    }

private:
    void open()
    {
        wordList columns{"Time"};
        for (const FieldInfo* field : fields_)
        {
            const word name = magnitudeName(*field);
            for (const word extreme : {"min", "max"})
            {
                const word column = extreme + "(" + name + ")";
                columns.insert
                (
                    columns.end(), {column, column + ".x", column + ".y"}
                );
            }
        }
        file_ = std::make_unique<DataFile>
        (
            folder_.path()/(name_ + ".dat"),
            wordList{"Time [s]; values in SI units, each with its place [m]"},
            columns
        );
    }

    void appendExtremes(const FieldInfo& field, std::vector<scalar>& row) const
    {
        const auto [begin, end] = particles_.granular();
        label lowest = begin, highest = begin;
        for (label i = begin; i < end; ++i)
        {
            const scalar value = magnitude(field, i);
            if (value < magnitude(field, lowest))
            {
                lowest = i;
            }
            if (value > magnitude(field, highest))
            {
                highest = i;
            }
        }
        for (const label i : {lowest, highest})
        {
            row.insert
            (
                row.end(),
                {magnitude(field, i), particles_.r.x[i], particles_.r.y[i]}
            );
        }
    }
};

static const FunctionObject::Add<fieldMinMax> add
(
    "fieldMinMax", "least and greatest value of fields, with their places"
);

} // namespace
} // namespace sph
