#include "deposit/slidingInterface.H"

#include <algorithm>
#include <cmath>

namespace sph
{

std::vector<vector> slidingInterface
(
    const Particles& particles, const scalar speed
)
{
    const label n = particles.granular().end;
    if (n == 0)
    {
        return {};
    }
    const scalar dx = particles.spacing(), width = 2*dx;
    const scalar* x = particles.r.x.data();
    const scalar left = *std::min_element(x, x + n) - 0.5*dx;
    const scalar right = *std::max_element(x, x + n) + 0.5*dx;
    std::vector<labelField> columns(label((right - left)/width) + 1);
    for (label i = 0; i < n; ++i)
    {
        columns[label((x[i] - left)/width)].push_back(i);
    }

    std::vector<vector> line;
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
        labelField& column = columns[c];
        std::sort
        (
            column.begin(), column.end(),
            [&](const label i, const label j)
            {
                return particles.r.y[i] > particles.r.y[j];
            }
        );
        const auto resting = std::find_if
        (
            column.begin(), column.end(),
            [&](const label i) { return particles.U[i].norm() < speed; }
        );
        if (resting != column.begin())
        {
            const scalar half = resting == column.end() ? -0.5 : 0.5;
            const label i = resting == column.end() ? column.back() : *resting;
            line.push_back
            (
                {left + (c + 0.5)*width, particles.r.y[i] + half*dx}
            );
        }
    }
    return line;
}

} // namespace sph
