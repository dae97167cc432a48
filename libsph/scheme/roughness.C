#include "scheme/roughness.H"

#include "pairs/CellGrid.H"

#include <Eigen/Cholesky>
#include <cmath>

namespace sph
{

namespace
{

// Difference of a pressure from the plane through those around it
std::optional<scalar> difference
(
    const label i, const CellGrid& grid, const Particles& particles
)
{
    const scalar dx = particles.spacing();
    Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    label n = 0;
    CellGrid::Run runs[3];
    grid.runsAround(particles.r.x[i], particles.r.y[i], runs);
    for (const CellGrid::Run& run : runs)
    {
        for (label k = run.begin; k < run.end; ++k)
        {
            const label j = grid.particles()[k];
            const vector d = (particles.r[j] - particles.r[i])/dx;
            if (d.squaredNorm() <= 4)
            {
                const Eigen::Vector3d row(1, d.x(), d.y());
                M += row*row.transpose();
                b += particles.p[j]*row;
                ++n;
            }
        }
    }
    if (n < 7)
    {
        return {};
    }
    return particles.p[i] - M.ldlt().solve(b)[0];
}

} // namespace

std::optional<scalar> roughness(const Particles& particles)
{
    CellGrid grid;
    grid.build(particles.r, {particles.granular()}, 2*particles.spacing());
    label n = 0;
    scalar squares = 0, total = 0;
    for (label i = 0; i < particles.granular().end; ++i)
    {
        if (particles.lambda[i] <= 0.75)
        {
            continue;
        }
        if (const auto d = difference(i, grid, particles))
        {
            ++n;
            squares += *d * *d;
            total += particles.p[i]*particles.p[i];
        }
    }
    if (n < 10 || !(total > 0))
    {
        return {};
    }
    return std::sqrt(squares/total);
}

} // namespace sph
