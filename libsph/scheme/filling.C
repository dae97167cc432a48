#include "scheme/filling.H"

#include "kernels/Kernel.H"
#include "pairs/CellGrid.H"

#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{

using Square = std::pair<std::int64_t, std::int64_t>;

// Squares of a width that hold particles, each once
std::vector<Square> occupied(const Particles& particles, const scalar width)
{
    std::vector<Square> squares;
    for (label i = 0; i < particles.granular().end; ++i)
    {
        const vector r = particles.r[i]/width;
        squares.emplace_back(std::floor(r.x()), std::floor(r.y()));
    }
    std::sort(squares.begin(), squares.end());
    squares.erase
    (
        std::unique(squares.begin(), squares.end()), squares.end()
    );
    return squares;
}

scalar fraction(const scalar x)
{
    return x - std::floor(x);
}

// Up, down, left or right
int side(const vector& d)
{
    return std::abs(d.x()) > std::abs(d.y()) ? d.x() > 0 : 2 + (d.y() > 0);
}

// The sum at a place, or 0 unless particles surround it: on each side one that
// is beyond the nearest row, and their middle close by
scalar sumAround
(
    const vector& place, const CellGrid& grid, const Particles& particles,
    const Kernel& kernel
)
{
    const scalar dx = particles.spacing();
    scalar sum = 0;
    vector towards = vector::Zero();
    bool sides[4] = {};
    CellGrid::Run runs[3];
    grid.runsAround(place.x(), place.y(), runs);
    for (const CellGrid::Run& run : runs)
    {
        for (label k = run.begin; k < run.end; ++k)
        {
            const label j = grid.particles()[k];
            const vector d = particles.r[j] - place;
            const scalar VW = particles.V[j]*kernel.W(d.norm());
            sum += VW;
            towards += VW*d;
            if (VW > 0 && d.norm() > 0.75*dx)
            {
                sides[side(d)] = true;
            }
        }
    }
    const bool all = sides[0] && sides[1] && sides[2] && sides[3];
    return all && towards.norm() < 0.12*dx*sum ? sum : 0;
}

} // namespace

std::optional<scalar> filling(const Particles& particles)
{
    const auto kernel = Kernel::New
    (
        dictionary::fromString("kernel WendlandC2;"), "kernel",
        particles.spacing()
    );
    const scalar width = kernel->cutOff();
    CellGrid grid;
    grid.build(particles.r, {particles.granular()}, width);
    label n = 0;
    scalar total = 0;
    for (const auto& [column, row] : occupied(particles, width))
    {
        // Irrational shifts: no lattice is met at the same places
        const vector shift
        (
            fraction(0.618034*column + 0.381966*row),
            fraction(0.754878*column + 0.569840*row)
        );
        for (int k = 0; k < 4; ++k)
        {
            const vector place = width*vector
            (
                column + fraction(shift.x() + 0.25*k),
                row + fraction(shift.y() + 0.5*k)
            );
            const scalar sum = sumAround(place, grid, particles, *kernel);
            n += sum > 0;
            total += sum;
        }
    }
    if (n < 10)
    {
        return std::nullopt;
    }
    return total/n;
}

} // namespace sph
