#include "particles/PairList.H"

#include "particles/lanes.H"

#include <omp.h>

#include <algorithm>

namespace sph
{

// Indices of the entries of the grid within reach of (x, y)
static label collect
(
    const CellGrid& grid, const scalar x, const scalar y,
    const scalar reachSqr, labelField& found
)
{
    CellGrid::Run runs[3];
    grid.runsAround(x, y, runs);
    label n = 0;
    for (const CellGrid::Run& run : runs)
    {
        const label nMax = n + run.end - run.begin + laneCount;
        if (nMax > label(found.size()))
        {
            found.resize(2*nMax);
        }
        label* list = found.data();
        const label* indices = grid.particles().data();
        for (label e = run.begin; e < run.end; e += laneCount)
        {
            const lanes dx = x - loadUnaligned(&grid.x()[e]);
            const lanes dy = y - loadUnaligned(&grid.y()[e]);
            n += appendWhereLess
            (
                dx*dx + dy*dy, reachSqr, run.end - e, indices + e, list + n
            );
        }
    }
    return n;
}

static bool contains(const ParticleRange& range, const label i)
{
    return i >= range.begin && i < range.end;
}

void PairList::build
(
    const vectorField& r, const ParticleRange& range,
    const CellGrid& grid, const ParticleRange candidates[2],
    const scalar reach, const label null
)
{
    first_ = range.begin;
    const label nSlices = (range.size() + laneCount - 1)/laneCount;
    slices_.resize(nSlices);
    offset_.resize(nSlices);
    storage_.resize(omp_get_max_threads());
    const scalar reachSqr = reach*reach;
    std::int64_t pairs = 0;

    #pragma omp parallel reduction(+: pairs)
    {
        labelField& rows = storage_[omp_get_thread_num()];
        thread_local labelField found[laneCount];
        rows.clear();

        #pragma omp for schedule(static)
        for (label slice = 0; slice < nSlices; ++slice)
        {
            label n[laneCount] = {}, nMax = 0;
            for (label lane = 0; lane < laneCount; ++lane)
            {
                const label i = range.begin + slice*laneCount + lane;
                if (i < range.end)
                {
                    const label all = collect
                    (
                        grid, r.x[i], r.y[i], reachSqr, found[lane]
                    );
                    label* list = found[lane].data();
                    n[lane] = label
                    (
                        std::remove_if
                        (
                            list, list + all,
                            [&](const label j)
                            {
                                return
                                    j == i
                                 || (
                                        !contains(candidates[0], j)
                                     && !contains(candidates[1], j)
                                    );
                            }
                        ) - list
                    );
                }
                nMax = std::max(nMax, n[lane]);
                pairs += n[lane];
            }

            offset_[slice] = rows.size();
            slices_[slice].n = nMax;
            rows.resize(rows.size() + nMax*laneCount);
            label* row = rows.data() + offset_[slice];
            for (label lane = 0; lane < laneCount; ++lane)
            {
                for (label k = 0; k < nMax; ++k)
                {
                    row[k*laneCount + lane] =
                        k < n[lane] ? found[lane][k] : null;
                }
            }
        }

        // Addresses are known once a thread's storage has stopped growing
        #pragma omp for schedule(static)
        for (label slice = 0; slice < nSlices; ++slice)
        {
            slices_[slice].rows = rows.data() + offset_[slice];
        }
    }
    pairCount_ = pairs;
}

} // namespace sph
