#include "pairs/PairWalk.H"

#include "pairs/FusedSums.H"

#include <algorithm>

namespace sph
{

void PairWalk::add(PairTerm& term)
{
    if (!term.hasSum())
    {
        return;
    }
    terms_.push_back(&term);
    for (const FieldInfo* info : term.fieldsRead(particles_))
    {
        if (std::find(fields_.begin(), fields_.end(), info) == fields_.end())
        {
            fields_.push_back(info);
        }
    }
}

// Calls walk(first term, group or null) for each pass over the pairs
template<class Walk>
static void forEachPass(const std::vector<PairTerm*>& terms, const Walk& walk)
{
    std::size_t k = 0;
    while (k < terms.size())
    {
        PairTerm* const* first = terms.data() + k;
        const FusedSums::Group* group =
            FusedSums::match(first, terms.size() - k);
        walk(first, group);
        k += group ? group->sums.size() : 1;
    }
}

void PairWalk::run
(
    const PairList& list, const Kernel& kernel, const label end
)
{
    rows_.resize(omp_get_max_threads());
    records_.resize(terms_.size());
    const bool packSleepers =
        packedFor_ != &list || packedVersion_ != list.version();
    packedFor_ = &list;
    packedVersion_ = list.version();

    std::size_t pass = 0;
    forEachPass
    (
        terms_,
        [&](PairTerm* const* first, const FusedSums::Group* group)
        {
            const PairRun run
            {
                particles_, list, end, kernel, records_[pass++], packSleepers,
                rows_
            };
            if (group)
            {
                group->walk(run, first);
            }
            else
            {
                (*first)->walk(run);
            }
        }
    );
}

label PairWalk::passes() const
{
    label n = 0;
    forEachPass
    (
        terms_, [&](PairTerm* const*, const FusedSums::Group*) { ++n; }
    );
    return n;
}

} // namespace sph
