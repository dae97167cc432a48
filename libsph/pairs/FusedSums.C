#include "pairs/FusedSums.H"

#include <algorithm>

namespace sph
{

std::vector<FusedSums::Group>& FusedSums::groups()
{
    static std::vector<Group> groups;
    return groups;
}

const FusedSums::Group* FusedSums::match
(
    PairTerm* const* terms, const std::size_t n
)
{
    const Group* longest = nullptr;
    for (const Group& group : groups())
    {
        const auto& sums = group.sums;
        const bool fits =
            sums.size() <= n
         && std::equal
            (
                sums.begin(), sums.end(), terms,
                [](const std::type_info* sum, const PairTerm* term)
                {
                    return *sum == term->sumType();
                }
            );
        if (fits && (!longest || sums.size() > longest->sums.size()))
        {
            longest = &group;
        }
    }
    return longest;
}

} // namespace sph
