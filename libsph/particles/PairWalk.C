#include "particles/PairWalk.H"

#include "particles/transpose.H"

#include <omp.h>

#include <algorithm>

namespace sph
{

PairWalk::Slot PairWalk::neighbour(const std::string& name)
{
    const FieldInfo& info = particles_.field(name);
    const auto iter = std::find
    (
        components_.begin(), components_.end(), info.components.front()
    );
    if (iter != components_.end())
    {
        return label(iter - components_.begin());
    }
    const Slot slot = label(components_.size());
    fields_.push_back(&info);
    components_.insert
    (
        components_.end(), info.components.begin(), info.components.end()
    );
    return slot;
}

label PairWalk::recordCount() const
{
    return roundUpToLanes(2 + label(components_.size()))/laneCount;
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
        columns[2 + c] = components_[c]->data();
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

// Buffer of a block, stride scalars each: [r.x r.y components... F W]
void PairWalk::fetchPacked
(
    const PairList::Slice& slice, PairBlock& block
) const
{
    const label nRecords = recordCount();
    const std::size_t recordSize = nRecords*laneCount;
    const label nComponents = label(components_.size());
    const laneRow xi = loadRow(&particles_.r.x[block.first]);
    const laneRow yi = loadRow(&particles_.r.y[block.first]);

    const auto fetch = [&]
    (
        const label k, const label record, laneRow (&rows)[laneCount]
    )
    {
        const label* index = slice.rows + k*laneCount;
        const scalar* base = records_.data() + record*laneCount;
        for (label lane = 0; lane < laneCount; ++lane)
        {
            rows[lane] = loadRow(base + index[lane]*recordSize);
        }
        transpose(rows);
    };

    for (label k = 0; k < slice.n; ++k)
    {
        laneRow rows[laneCount];
        fetch(k, 0, rows);
        const laneRow x = xi - rows[0], y = yi - rows[1];
        storeRow(x, block.r_ + k*laneCount);
        storeRow(y, block.r_ + block.stride_ + k*laneCount);
        storeRow(x*x + y*y, block.F_ + k*laneCount);

        scalar* values = block.values_ + k*laneCount;
        for (label c = 0; c < std::min(nComponents, laneCount - 2); ++c)
        {
            storeRow(rows[2 + c], values + c*block.stride_);
        }
        for (label record = 1; record < nRecords; ++record)
        {
            fetch(k, record, rows);
            const label first = record*laneCount - 2;
            for (label c = 0; c < std::min(nComponents - first, laneCount); ++c)
            {
                storeRow(rows[c], values + (first + c)*block.stride_);
            }
        }
    }
}

void PairWalk::fetchDirect
(
    const PairList::Slice& slice, PairBlock& block
) const
{
    const label n = slice.n*laneCount;
    const auto fetch = [&](const scalarField& field, scalar* values)
    {
        for (label k = 0; k < n; ++k)
        {
            values[k] = field[slice.rows[k]];
        }
    };
    fetch(particles_.r.x, block.r_);
    fetch(particles_.r.y, block.r_ + block.stride_);
    const vectorLanes ri = load(particles_.r, block.first);
    for (label k = 0; k < slice.n; ++k)
    {
        const vectorLanes rij = ri - block.r(k);
        store(rij.x, block.r_ + k*laneCount);
        store(rij.y, block.r_ + block.stride_ + k*laneCount);
        store(rij & rij, block.F_ + k*laneCount);
    }
    for (std::size_t c = 0; c < components_.size(); ++c)
    {
        fetch(*components_[c], block.values_ + c*block.stride_);
    }
}

void PairWalk::run(const PairList& list, const Kernel& kernel)
{
    if (fetch_ == Fetch::packed)
    {
        pack();
    }
    buffers_.resize(omp_get_max_threads());
    const label nComponents = label(components_.size());
    const label nSlices = label(list.slices().size());

    #pragma omp parallel
    {
        scalarField& buffer = buffers_[omp_get_thread_num()];

        #pragma omp for schedule(static)
        for (label s = 0; s < nSlices; ++s)
        {
            const PairList::Slice& slice = list.slices()[s];

            PairBlock block;
            block.stride_ = slice.n*laneCount;
            const std::size_t size = (nComponents + 4)*block.stride_;
            if (buffer.size() < size)
            {
                buffer.resize(size);
            }
            block.r_ = buffer.data();
            block.values_ = block.r_ + 2*block.stride_;
            block.F_ = block.values_ + nComponents*block.stride_;
            block.W_ = block.F_ + block.stride_;

            block.first = list.first() + s*laneCount;
            block.n = slice.n;
            if (fetch_ == Fetch::packed)
            {
                fetchPacked(slice, block);
            }
            else
            {
                fetchDirect(slice, block);
            }
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
