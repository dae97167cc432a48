#include "pairs/CellGrid.H"

#include <algorithm>
#include <cmath>

namespace sph
{

label CellGrid::cellOf(const scalar x, const scalar y) const
{
    const label cx = label((x - origin_.x())/width_);
    const label cy = label((y - origin_.y())/width_);
    return
        std::clamp(cy, 0, ny_ - 1)*nx_ + std::clamp(cx, 0, nx_ - 1);
}

void CellGrid::build
(
    const vectorField& r, const std::vector<ParticleRange>& ranges,
    const scalar width
)
{
    const scalar inf = std::numeric_limits<scalar>::infinity();
    scalar xMin = inf, xMax = -inf, yMin = inf, yMax = -inf;
    label n = 0;
    for (const ParticleRange& range : ranges)
    {
        n += range.size();
        #pragma omp simd reduction(min: xMin, yMin) reduction(max: xMax, yMax)
        for (label i = range.begin; i < range.end; ++i)
        {
            xMin = std::min(xMin, r.x[i]);
            xMax = std::max(xMax, r.x[i]);
            yMin = std::min(yMin, r.y[i]);
            yMax = std::max(yMax, r.y[i]);
        }
    }
    particle_.resize(n + laneCount);
    x_.resize(n + laneCount);
    y_.resize(n + laneCount);
    if (n == 0)
    {
        nx_ = ny_ = 0;
        return;
    }

    // Far more cells than particles would be empty space: widen the cells
    width_ = width;
    const scalar area = (xMax - xMin + width)*(yMax - yMin + width);
    const scalar maxCells = 4.0*n + 1024;
    if (area > maxCells*width*width)
    {
        width_ = std::sqrt(area/maxCells);
    }
    origin_ = {xMin, yMin};
    nx_ = label((xMax - xMin)/width_) + 1;
    ny_ = label((yMax - yMin)/width_) + 1;

    // Counting sort, stable
    start_.assign(nx_*ny_ + 1, 0);
    cell_.resize(n);
    label k = 0;
    for (const ParticleRange& range : ranges)
    {
        label* cell = cell_.data() + k - range.begin;
        #pragma omp parallel for simd schedule(static)
        for (label i = range.begin; i < range.end; ++i)
        {
            cell[i] = cellOf(r.x[i], r.y[i]);
        }
        k += range.size();
    }
    for (const label cell : cell_)
    {
        ++start_[cell + 1];
    }
    for (label c = 0; c < nx_*ny_; ++c)
    {
        start_[c + 1] += start_[c];
    }
    k = 0;
    for (const ParticleRange& range : ranges)
    {
        for (label i = range.begin; i < range.end; ++i, ++k)
        {
            const label entry = start_[cell_[k]]++;
            particle_[entry] = i;
            x_[entry] = r.x[i];
            y_[entry] = r.y[i];
        }
    }
    for (label c = nx_*ny_; c > 0; --c)
    {
        start_[c] = start_[c - 1];
    }
    start_[0] = 0;
}

void CellGrid::dilate(std::vector<char>& flags) const
{
    // Along rows, then across them; before: the flag of the cell passed last
    for (label y = 0; y < ny_; ++y)
    {
        char* row = flags.data() + std::size_t(y)*nx_;
        char before = 0;
        for (label x = 0; x < nx_; ++x)
        {
            const char here = row[x];
            row[x] |= before | (x + 1 < nx_ ? row[x + 1] : 0);
            before = here;
        }
    }
    for (label x = 0; x < nx_; ++x)
    {
        char before = 0;
        for (label y = 0; y < ny_; ++y)
        {
            char& flag = flags[std::size_t(y)*nx_ + x];
            const char here = flag;
            flag |= before
                | (y + 1 < ny_ ? flags[std::size_t(y + 1)*nx_ + x] : 0);
            before = here;
        }
    }
}

} // namespace sph
