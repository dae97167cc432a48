#include "particles/PairList.H"

#include <omp.h>

#include <algorithm>

namespace sph
{

// The candidates of the grid within reach of (x, y), i itself excepted
static void collect
(
    const CellGrid& grid, const ParticleRange candidates[2],
    const scalar x, const scalar y, const label i,
    const scalar reachSqr, labelField& found, label& n
)
{
    CellGrid::Run runs[3];
    grid.runsAround(x, y, runs);
    n = 0;
    for (const CellGrid::Run& run : runs)
    {
        if (n + run.end - run.begin > label(found.size()))
        {
            found.resize(n + run.end - run.begin);
        }
        label* list = found.data();
        const scalar* xs = grid.x().data();
        const scalar* ys = grid.y().data();
        const label* indices = grid.particles().data();
        for (label entry = run.begin; entry < run.end; ++entry)
        {
            const scalar dx = x - xs[entry], dy = y - ys[entry];
            const label j = indices[entry];
            list[n] = j;
            n +=
                (dx*dx + dy*dy < reachSqr) & (j != i)
              & (
                    ((j >= candidates[0].begin) & (j < candidates[0].end))
                  | ((j >= candidates[1].begin) & (j < candidates[1].end))
                );
        }
    }
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
                    collect
                    (
                        grid, candidates, r.x[i], r.y[i], i, reachSqr,
                        found[lane], n[lane]
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
