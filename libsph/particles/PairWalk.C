#include "particles/PairWalk.H"

#include "particles/transpose.H"
#include "primitives/error.H"

#include <omp.h>

#include <algorithm>

namespace sph
{

// Behind the position
static constexpr PairWalk::Slot firstSlot = 2;

static constexpr label maxRecords = 4;

PairWalk::Slot PairWalk::neighbour(const std::string& name)
{
    const FieldInfo& info = particles_.field(name);
    const auto iter = std::find
    (
        components_.begin(), components_.end(), info.components.front()
    );
    if (iter != components_.end())
    {
        return firstSlot + label(iter - components_.begin());
    }
    const Slot slot = firstSlot + label(components_.size());
    fields_.push_back(&info);
    components_.insert
    (
        components_.end(), info.components.begin(), info.components.end()
    );
    if (fetch_ == Fetch::packed && recordCount() > maxRecords)
    {
        throw Error
        (
            "The terms of a pair walk ask for more than "
          + std::to_string(maxRecords*laneCount - firstSlot)
          + " values of the neighbours; the last one was " + name
        );
    }
    return slot;
}

label PairWalk::recordCount() const
{
    return roundUpToLanes(firstSlot + label(components_.size()))/laneCount;
}

// One record a particle: position and components, rounded up to cache lines
void PairWalk::pack()
{
    const label nRecords = recordCount();
    const std::size_t recordSize = nRecords*laneCount;
    const label size = roundUpToLanes(particles_.size());
    records_.resize(size*recordSize);

    std::vector<const scalar*>& columns = columns_;
    columns.assign(recordSize, particles_.r.x.data());
    columns[1] = particles_.r.y.data();
    for (std::size_t c = 0; c < components_.size(); ++c)
    {
        columns[firstSlot + c] = components_[c]->data();
    }

    #pragma omp parallel for schedule(static)
    for (label i = 0; i < size; i += laneCount)
    {
        for (label record = 0; record < nRecords; ++record)
        {
            laneRow rows[laneCount];
            for (label c = 0; c < laneCount; ++c)
            {
                rows[c] = loadRow(columns[record*laneCount + c] + i);
            }
            transpose(rows);
            for (label lane = 0; lane < laneCount; ++lane)
            {
                storeRow
                (
                    rows[lane],
                    &records_[(i + lane)*recordSize + record*laneCount]
                );
            }
        }
    }
}

template<label nRecords>
void PairWalk::fetchPacked
(
    const PairList::Slice& slice, PairBlock& block
) const
{
    constexpr std::size_t recordSize = nRecords*laneCount;
    const laneRow xi = loadRow(&particles_.r.x[block.first]);
    const laneRow yi = loadRow(&particles_.r.y[block.first]);
    const label* index = slice.rows;
    scalar* row = block.rows_;

    for (label k = 0; k < slice.n; ++k)
    {
        for (label record = 0; record < nRecords; ++record)
        {
            const scalar* base = records_.data() + record*laneCount;
            laneRow values[laneCount];
            for (label lane = 0; lane < laneCount; ++lane)
            {
                values[lane] = loadRow(base + index[lane]*recordSize);
            }
            transpose(values);
            if (record == 0)
            {
                values[0] = xi - values[0];
                values[1] = yi - values[1];
                storeRow
                (
                    values[0]*values[0] + values[1]*values[1],
                    block.F_ + k*laneCount
                );
            }
            for (label c = 0; c < laneCount; ++c)
            {
                storeRow(values[c], row + c*laneCount);
            }
            row += laneCount*laneCount;
        }
        index += laneCount;
    }
}

void PairWalk::fetchDirect
(
    const PairList::Slice& slice, PairBlock& block
) const
{
    const vectorLanes ri = load(particles_.r, block.first);
    for (label k = 0; k < slice.n; ++k)
    {
        const label* index = slice.rows + k*laneCount;
        scalar* row = block.rows_ + k*block.rowSize_;
        const auto fetch = [&](const scalarField& field, const label c)
        {
            for (label lane = 0; lane < laneCount; ++lane)
            {
                row[c*laneCount + lane] = field[index[lane]];
            }
        };
        fetch(particles_.r.x, 0);
        fetch(particles_.r.y, 1);
        for (std::size_t c = 0; c < components_.size(); ++c)
        {
            fetch(*components_[c], firstSlot + label(c));
        }
        const vectorLanes rij = ri - block.r(k);
        store(rij.x, row);
        store(rij.y, row + laneCount);
        store(rij & rij, block.F_ + k*laneCount);
    }
}

void PairWalk::fetch(const PairList::Slice& slice, PairBlock& block) const
{
    if (fetch_ == Fetch::direct)
    {
        return fetchDirect(slice, block);
    }
    switch (recordCount())
    {
        case 1: return fetchPacked<1>(slice, block);
        case 2: return fetchPacked<2>(slice, block);
        case 3: return fetchPacked<3>(slice, block);
        case maxRecords: return fetchPacked<maxRecords>(slice, block);
    }
}

void PairWalk::run(const PairList& list, const Kernel& kernel)
{
    if (fetch_ == Fetch::packed)
    {
        pack();
    }
    buffers_.resize(omp_get_max_threads());
    const label nSlices = label(list.slices().size());

    #pragma omp parallel
    {
        scalarField& buffer = buffers_[omp_get_thread_num()];

        #pragma omp for schedule(static)
        for (label s = 0; s < nSlices; ++s)
        {
            const PairList::Slice& slice = list.slices()[s];

            // [rows][F][W]
            PairBlock block;
            block.first = list.first() + s*laneCount;
            block.n = slice.n;
            block.rowSize_ = recordCount()*laneCount*laneCount;
            const std::size_t size =
                slice.n*(block.rowSize_ + 2*laneCount);
            if (buffer.size() < size)
            {
                buffer.resize(size);
            }
            block.rows_ = buffer.data();
            block.F_ = block.rows_ + slice.n*block.rowSize_;
            block.W_ = block.F_ + slice.n*laneCount;

            fetch(slice, block);
            kernel.evaluate
            (
                slice.n, block.F_, block.F_, needsW_ ? block.W_ : nullptr
            );
            for (PairTerm* term : terms_)
            {
                term->evaluate(block);
            }
        }
    }
}

} // namespace sph
