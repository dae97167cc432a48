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
    const label size = particles_.size();
    const std::size_t recordSize = recordCount()*laneCount;
    records_.resize(size*recordSize);
    const label nComponents = label(components_.size());

    #pragma omp parallel for schedule(static)
    for (label i = 0; i < size; ++i)
    {
        scalar* record = &records_[i*recordSize];
        record[0] = particles_.r.x[i];
        record[1] = particles_.r.y[i];
        for (label c = 0; c < nComponents; ++c)
        {
            record[2 + c] = (*components_[c])[i];
        }
    }
}

// Buffer of a block: [r.x r.y components... padding][rSqr][F][W], each of
// stride scalars
void PairWalk::fetchPacked
(
    const PairList::Slice& slice, PairBlock& block
) const
{
    const label nRecords = recordCount();
    const std::size_t recordSize = nRecords*laneCount;
    for (label k = 0; k < slice.n; ++k)
    {
        for (label c = 0; c < nRecords; ++c)
        {
            transposeRecords
            (
                records_.data() + c*laneCount, recordSize,
                slice.rows + k*laneCount,
                block.r_ + c*laneCount*block.stride_ + k*laneCount,
                block.stride_
            );
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
    for (std::size_t c = 0; c < components_.size(); ++c)
    {
        fetch(*components_[c], block.values_ + c*block.stride_);
    }
}

// r_ij = r_i - r_j in place of r_j
void PairWalk::setGeometry(const vectorLanes& ri, PairBlock& block)
{
    for (label k = 0; k < block.n; ++k)
    {
        const vectorLanes rij = ri - block.r(k);
        store(rij.x, block.r_ + k*laneCount);
        store(rij.y, block.r_ + block.stride_ + k*laneCount);
        store(rij & rij, block.rSqr_ + k*laneCount);
    }
}

void PairWalk::run(const PairList& list, const Kernel& kernel)
{
    if (fetch_ == Fetch::packed)
    {
        pack();
    }
    buffers_.resize(omp_get_max_threads());
    const label nComponents = recordCount()*laneCount;
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
            const std::size_t size = (nComponents + 3)*block.stride_;
            if (buffer.size() < size)
            {
                buffer.resize(size);
            }
            block.r_ = buffer.data();
            block.values_ = block.r_ + 2*block.stride_;
            block.rSqr_ = block.r_ + nComponents*block.stride_;
            block.F_ = block.rSqr_ + block.stride_;
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
            setGeometry(load(particles_.r, block.first), block);
            kernel.evaluate
            (
                slice.n, block.rSqr_, block.F_, needsW_ ? block.W_ : nullptr
            );
            for (PairTerm* term : terms_)
            {
                term->evaluate(block);
            }
        }
    }
}

} // namespace sph
