// Points in two columns of a text file, in order (io/ColumnFile.H).
//
//     geometry { file "constant/geometry/bed.csv"; columns (x z); }

#include "geometry/GeometryFormat.H"
#include "io/ColumnFile.H"

namespace sph
{
namespace
{

class csv : public GeometryFormat
{
    const wordList columns_;

public:
    csv(const dictionary& dict, const std::filesystem::path& path)
    :
        GeometryFormat(path),
        columns_
        (
            dict.getOrDefault<wordList>
            (
                {"columns", "names of the columns of x and y"}, {"x", "y"}
            )
        )
    {
        if (columns_.size() != 2)
        {
            dict.fail("columns", "Two columns are needed, such as (x y)");
        }
    }

    std::vector<FileLine> lines() const override
    {
        const ColumnFile file(path());
        const label x = file.column(columns_[0]);
        const label y = file.column(columns_[1]);
        FileLine line{{}, file.lines(), true};
        for (const auto& row : file.rows())
        {
            line.points.emplace_back(row[x], row[y]);
        }
        return {line};
    }
};

static const GeometryFormat::Add<csv> add
(
    "csv", "text in columns: one line, its points in order"
);

} // namespace
} // namespace sph
