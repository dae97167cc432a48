#include "functionObjects/ProfileReference.H"

#include "io/ColumnFile.H"

#include <cmath>

namespace sph
{

ProfileReference::ProfileReference
(
    const dictionary& dict, const std::filesystem::path& caseDir
)
:
    field_(dict.get<word>("field")),
    timed_(dict.found("time")),
    band_(dict.getOrDefault("band", 0, dimless, Range::nonNegative()))
{
    const ColumnFile table(caseDir/dict.get<word>("file"));
    const auto columns = dict.get<wordList>("columns");
    if (columns.size() != 2)
    {
        dict.fail("columns", "Two columns are needed: distance and value");
    }
    const label x = table.column(columns[0]), y = table.column(columns[1]);
    const label time = timed_ ? table.column(dict.get<word>("time")) : -1;

    const dictionary& where = dict.subOrEmptyDict("where");
    std::vector<std::pair<label, scalar>> wanted;
    for (const word& name : where.toc())
    {
        wanted.emplace_back(table.column(name), where.get<scalar>(name));
    }
    for (const auto& row : table.rows())
    {
        bool chosen = true;
        for (const auto& [column, value] : wanted)
        {
            chosen = chosen
                && std::abs(row[column] - value) <= 1e-9*std::abs(value);
        }
        if (chosen)
        {
            curves_[timed_ ? row[time] : 0].add(row[x], row[y]);
        }
    }
    if (curves_.empty())
    {
        dict.fail("where", "No row of the reference has these values");
    }
}

const ReferenceCurve* ProfileReference::at(const scalar time) const
{
    for (const auto& [t, curve] : curves_)
    {
        if (!timed_ || std::abs(time - t) <= 2e-3*t)
        {
            return &curve;
        }
    }
    return nullptr;
}

word ProfileReference::verdict(const scalar L2) const
{
    return band_ == 0 ? "none" : L2 <= band_ ? "passed" : "failed";
}

} // namespace sph
