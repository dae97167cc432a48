#include "pairs/PairList.H"

#include "pairs/transpose.H"

#include <omp.h>

#include <algorithm>

namespace sph
{

// Appends to list those of the entries e ... end - 1 of the grid, laneCount at
// most, that are within reach of (x, y), in order, but for i itself. laneCount
// places at list must be there. Returns how many were appended.
static inline label appendWithinReach
(
    const CellGrid& grid, const label e, const label end,
    const scalar x, const scalar y, const scalar reachSqr, const label i,
    label* list
)
{
    const label* indices = grid.particles().data() + e;
#ifdef __AVX512VL__
    const __m512d dx = _mm512_set1_pd(x) - _mm512_loadu_pd(&grid.x()[e]);
    const __m512d dy = _mm512_set1_pd(y) - _mm512_loadu_pd(&grid.y()[e]);
    const __m256i j = _mm256_loadu_si256
    (
        reinterpret_cast<const __m256i*>(indices)
    );
    const __mmask8 found =
        ((1u << std::min(end - e, laneCount)) - 1)
      & _mm512_cmp_pd_mask
        (
            dx*dx + dy*dy, _mm512_set1_pd(reachSqr), _CMP_LT_OQ
        )
      & _mm256_cmpneq_epi32_mask(j, _mm256_set1_epi32(i));
    _mm256_storeu_si256
    (
        reinterpret_cast<__m256i*>(list),
        _mm256_maskz_compress_epi32(found, j)
    );
    return __builtin_popcount(found);
#else
    label n = 0;
    for (label k = 0; k < std::min(end - e, laneCount); ++k)
    {
        const scalar dx = x - grid.x()[e + k], dy = y - grid.y()[e + k];
        list[n] = indices[k];
        n += (dx*dx + dy*dy < reachSqr) & (indices[k] != i);
    }
    return n;
#endif
}

// Indices of the entries of the grid within reach of particle i at (x, y)
static label collect
(
    const CellGrid& grid, const scalar x, const scalar y,
    const scalar reachSqr, const label i, labelField& found
)
{
    CellGrid::Run runs[3];
    grid.runsAround(x, y, runs);
    label n = 0;
    for (const CellGrid::Run& run : runs)
    {
        // Room for a last, partly filled row as well
        const label nMax = n + run.end - run.begin + 2*laneCount;
        if (nMax > label(found.size()))
        {
            found.resize(2*nMax);
        }
        label* list = found.data();
        for (label e = run.begin; e < run.end; e += laneCount)
        {
            n += appendWithinReach
            (
                grid, e, run.end, x, y, reachSqr, i, list + n
            );
        }
    }
    return n;
}

static bool contains(const ParticleRange& range, const label i)
{
    return i >= range.begin && i < range.end;
}

// Those of n indices that are in one of two ranges; returns how many
static label keepCandidates
(
    label* list, const label n, const ParticleRange candidates[2]
)
{
    return label
    (
        std::remove_if
        (
            list, list + n,
            [&](const label j)
            {
                return
                    !contains(candidates[0], j)
                 && !contains(candidates[1], j);
            }
        ) - list
    );
}

// laneCount lists side by side, filled up with null
static void writeRows
(
    labelField (&lists)[laneCount], const label (&n)[laneCount],
    const label nMax, const label null, label* rows
)
{
    using Row = rowOf<label, laneCount>;
    const label size = roundUpToLanes(nMax);
    for (label lane = 0; lane < laneCount; ++lane)
    {
        if (label(lists[lane].size()) < size)
        {
            lists[lane].resize(size);
        }
        std::fill
        (
            lists[lane].data() + n[lane], lists[lane].data() + size, null
        );
    }
    for (label k = 0; k < nMax; k += laneCount)
    {
        Row block[laneCount];
        for (label lane = 0; lane < laneCount; ++lane)
        {
            block[lane] = loadRow<Row>(&lists[lane][k]);
        }
        transpose(block);
        for (label row = 0; row < std::min(nMax - k, laneCount); ++row)
        {
            storeRow(block[row], rows + (k + row)*laneCount);
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
    const bool filtered = candidates[0].begin > 0 || candidates[0].end < null;

    #pragma omp parallel reduction(+: pairs)
    {
        labelField& rows = storage_[omp_get_thread_num()];
        thread_local labelField found[laneCount];
        rows.clear();

        #pragma omp for schedule(static) nowait
        for (label slice = 0; slice < nSlices; ++slice)
        {
            label n[laneCount] = {}, nMax = 0;
            for (label lane = 0; lane < laneCount; ++lane)
            {
                const label i = range.begin + slice*laneCount + lane;
                if (i < range.end)
                {
                    n[lane] = collect
                    (
                        grid, r.x[i], r.y[i], reachSqr, i, found[lane]
                    );
                    if (filtered)
                    {
                        n[lane] = keepCandidates
                        (
                            found[lane].data(), n[lane], candidates
                        );
                    }
                }
                nMax = std::max(nMax, n[lane]);
                pairs += n[lane];
            }

            offset_[slice] = rows.size();
            slices_[slice].n = nMax;
            resizeSparingly(rows, rows.size() + nMax*laneCount);
            label* row = rows.data() + offset_[slice];
            writeRows(found, n, nMax, null, row);
        }

        // A walk looks ahead beyond the last row
        resizeSparingly(rows, rows.size() + rowsAhead*laneCount, null);

        // Addresses are known once a thread's storage has stopped growing
        #pragma omp for schedule(static)
        for (label slice = 0; slice < nSlices; ++slice)
        {
            slices_[slice].rows = rows.data() + offset_[slice];
        }
    }
    pairCount_ = pairs;
    ++version_;
}

} // namespace sph
