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
    field_
    (
        dict.get<word>({"field", "component that is compared", "U.x"})
    ),
    timed_
    (
        dict.found
        (
            {"time", "column with the time; else every call counts", "t_s"}
        )
    ),
    band_
    (
        dict.getOrDefault
        (
            {"band", "greatest error in L2; 0: no verdict"}, 0,
            dimless, Range::nonNegative()
        )
    )
{
    const word file = dict.get<word>
    ({
        "file", "table, from the case", "\"validation/bagnold.csv\""
    });
    const auto columns = dict.get<wordList>
    (
        {"columns", "columns with distance and value", "(y_m u_m_s)"}
    );
    if (columns.size() != 2)
    {
        dict.fail("columns", "Two columns are needed: distance and value");
    }
    const word timeColumn = timed_ ? dict.get<word>("time") : "";
    const Key whereKey
    (
        "where", "columns and the value that rows must have to count",
        "{ theta_deg 24; }"
    );
    std::vector<std::pair<word, scalar>> conditions;
    if (dict.found(whereKey))
    {
        const dictionary& where = dict.subDict("where");
        for (const word& name : where.toc())
        {
            conditions.emplace_back
            (
                name, where.get<scalar>({name, "value of this column"})
            );
        }
    }

    const ColumnFile table(caseDir/file);
    const label x = table.column(columns[0]), y = table.column(columns[1]);
    const label time = timed_ ? table.column(timeColumn) : -1;
    std::vector<std::pair<label, scalar>> wanted;
    for (const auto& [name, value] : conditions)
    {
        wanted.emplace_back(table.column(name), value);
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
