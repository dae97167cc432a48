// The dummy particles of a wall.
#include "boundaries/Wall.H"

#include "boundaries/Places.H"

namespace sph
{

std::vector<vector> Wall::offset(const scalar depth) const
{
    std::vector<vector> moved(points_.size());
    for (label v = 0; v <= segmentCount(); ++v)
    {
        const auto [before, after] = corner(v);
        const vector a = normal(before), b = normal(after);
        // Mitre: the point at the given depth behind both segments
        moved[v] = points_[v] - depth/(1 + a.dot(b))*(a + b);
    }
    return moved;
}

// Bends of less than 30 degrees are gentle
bool Wall::endsRow(const label point) const
{
    const auto [before, after] = corner(point);
    const bool end = point == 0 || point == segmentCount();
    return end || tangent(before).dot(tangent(after)) < 0.866;
}

// Particles at equal distances along segments [begin, end), moved back
void Wall::addRow
(
    const label begin, const label end, const scalar depth,
    std::vector<WallParticle>& row
) const
{
    const std::vector<vector> line = offset(depth);
    std::vector<scalar> lengths;
    scalar total = 0;
    for (label s = begin; s < end; ++s)
    {
        // A side that a re-entrant corner has used up has no length
        lengths.push_back
        (
            std::max((line[s + 1] - line[s]).dot(tangent(s)), 0.0)
        );
        total += lengths.back();
    }
    if (total <= 0)
    {
        return;
    }
    const scalar share = 1.0/perSpacing();
    const label n =
        std::max<label>(1, std::lround(total/(share*spacing())));
    label s = begin;
    scalar passed = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar along = (i + 0.5)*total/n;
        while (s < end - 1 && along > passed + lengths[s - begin])
        {
            passed += lengths[s - begin];
            ++s;
        }
        const vector r = line[s] + (along - passed)*tangent(s);
        row.push_back({r, normal(s), depth, -1, share});
    }
}

// Row by row, so that where the wall is too thin for all of them those near its
// surface have the place. Rows that end at an acute corner come near each other
// there: together they have the mass of what they stand for.
std::vector<WallParticle> Wall::wallParticles() const
{
    const scalar dx = spacing();
    const scalar farthest = 1.42*layers_*dx;    // the corner of a square
    Places places(0.24*dx);
    std::vector<WallParticle> particles;
    for (label layer = 0; layer < layers_; ++layer)
    {
        const scalar depth = (layer + 0.5)*dx;
        for (label begin = 0, end = 1; begin < segmentCount(); begin = end++)
        {
            while (!endsRow(end))
            {
                ++end;
            }
            std::vector<WallParticle> row;
            addRow(begin, end, depth, row);
            for (const WallParticle& w : row)
            {
                // Nearer to another side it is not this one's
                const scalar behind = -foot(w.r).distance;
                const bool own = behind > depth - 0.25*dx;
                if (own && behind < farthest && places.free(w.r))
                {
                    places.take(w.r);
                    particles.push_back(w);
                }
            }
        }
    }
    return particles;
}

} // namespace sph
