#include "pairs/DisplacementGauge.H"

#include "particles/team.H"

#include <algorithm>
#include <limits>

namespace sph
{

static constexpr scalar inf = std::numeric_limits<scalar>::infinity();

const DisplacementGauge::Box DisplacementGauge::empty{{inf, inf, inf, inf}};

void DisplacementGauge::include(Box& box, const Box& other)
{
    for (int k = 0; k < 4; ++k)
    {
        box.least[k] = std::min(box.least[k], other.least[k]);
    }
}

scalar DisplacementGauge::sizeSqr(const Box& box)
{
    const scalar dx = std::max(-box.least[0] - box.least[1], 0.0);
    const scalar dy = std::max(-box.least[2] - box.least[3], 0.0);
    return dx*dx + dy*dy;
}

void DisplacementGauge::reset
(
    const vectorField& r, const std::vector<ParticleRange>& ranges
)
{
    ranges_ = ranges;
    rBuilt_.x.assign(r.x.begin(), r.x.end());
    rBuilt_.y.assign(r.y.begin(), r.y.end());
}

// Square of twice the largest displacement: none of a pair is larger
scalar DisplacementGauge::maxSizeSqr(const vectorField& r) const
{
    const scalar* rx = r.x.data();
    const scalar* ry = r.y.data();
    const scalar* bx = rBuilt_.x.data();
    const scalar* by = rBuilt_.y.data();
    scalar largest = 0;
    for (const ParticleRange& range : ranges_)
    {
        #pragma omp parallel for simd schedule(static) reduction(max: largest) \
            if(parallel: worthATeam(range.size()))
        for (label i = range.begin; i < range.end; ++i)
        {
            const scalar dx = rx[i] - bx[i], dy = ry[i] - by[i];
            const scalar dSqr = dx*dx + dy*dy;
            largest = dSqr > largest ? dSqr : largest;
        }
    }
    return 4*largest;
}

// Of the particles in a cell
DisplacementGauge::Box DisplacementGauge::boxOf
(
    const vectorField& r, const CellGrid& grid, const label cell
) const
{
    Box box = empty;
    const CellGrid::Run run = grid.entries(cell);
    for (label e = run.begin; e < run.end; ++e)
    {
        const label i = grid.particles()[e];
        const scalar dx = r.x[i] - grid.x()[e], dy = r.y[i] - grid.y()[e];
        include(box, {{dx, -dx, dy, -dy}});
    }
    return box;
}

// Over the five by five cells around each: along rows, then across them
scalar DisplacementGauge::maxLocalSizeSqr
(
    const vectorField& r, const CellGrid& grid
)
{
    const label nx = grid.nx(), ny = grid.ny();
    boxes_.resize(std::size_t(nx)*ny);
    rowBoxes_.resize(boxes_.size());
    scalar largest = 0;
    #pragma omp parallel if(worthATeam(label(rBuilt_.x.size())))
    {
        #pragma omp for schedule(static)
        for (label y = 0; y < ny; ++y)
        {
            Box* row = boxes_.data() + std::size_t(y)*nx;
            for (label x = 0; x < nx; ++x)
            {
                row[x] = boxOf(r, grid, y*nx + x);
            }
            for (label x = 0; x < nx; ++x)
            {
                Box box = empty;
                const label end = std::min(x + 3, nx);
                for (label other = std::max(x - 2, 0); other < end; ++other)
                {
                    include(box, row[other]);
                }
                rowBoxes_[std::size_t(y)*nx + x] = box;
            }
        }
        #pragma omp for schedule(static) reduction(max: largest)
        for (label y = 0; y < ny; ++y)
        {
            const label begin = std::max(y - 2, 0), end = std::min(y + 3, ny);
            for (label x = 0; x < nx; ++x)
            {
                Box box = empty;
                for (label other = begin; other < end; ++other)
                {
                    include(box, rowBoxes_[std::size_t(other)*nx + x]);
                }
                largest = std::max(largest, sizeSqr(box));
            }
        }
    }
    return largest;
}

bool DisplacementGauge::complete
(
    const vectorField& r, const CellGrid& grid,
    const scalar cutOff, const scalar skin
)
{
    const scalar anywhere = maxSizeSqr(r);
    if (anywhere < skin*skin)
    {
        return true;
    }
    const scalar reach = cutOff + skin;
    if (!(anywhere < (reach + skin)*(reach + skin)))
    {
        return false;
    }
    return maxLocalSizeSqr(r, grid) < skin*skin;
}

} // namespace sph
