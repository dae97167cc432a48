#include "boundaries/Wall.H"

#include "runTime/log.H"

#include <cmath>

namespace sph
{

Wall::Wall(const dictionary& dict, const word& name, const scalar spacing)
:
    Boundary(name, spacing),
    points_(dict.get<std::vector<vector>>("points")),
    layers_(dict.getOrDefault<label>("layers", 3)),
    velocity_
    (
        dict.getVectorOrDefault("velocity", vector::Zero(), dimVelocity)
    )
{
    if (points_.size() < 2)
    {
        dict.fail("points", "A wall needs at least two points");
    }
    for (label s = 0; s < segmentCount(); ++s)
    {
        if ((points_[s + 1] - points_[s]).norm() < 1e-6*spacing)
        {
            dict.fail("points", "Two points of the wall coincide");
        }
    }
    if (layers_ < 1)
    {
        dict.fail("layers", "A wall needs at least one layer of particles");
    }
    closed_ = points_.size() > 3
        && (points_.front() - points_.back()).norm() < 1e-6*spacing;
}

vector Wall::tangent(const label segment) const
{
    return (points_[segment + 1] - points_[segment]).normalized();
}

// To the left
vector Wall::normal(const label segment) const
{
    const vector t = tangent(segment);
    return {-t.y(), t.x()};
}

scalar Wall::distance(const vector& point) const
{
    // Nearest foot on the polyline; its sign is that of the nearer segment,
    // at a corner that of the segment which the point faces most
    scalar best = std::numeric_limits<scalar>::infinity();
    scalar bestSide = 0;
    for (label s = 0; s < segmentCount(); ++s)
    {
        const scalar length = (points_[s + 1] - points_[s]).norm();
        const vector t = tangent(s);
        const vector d = point - points_[s];
        const scalar along = d.dot(t);
        const bool first = s == 0 && !closed_;
        const bool last = s == segmentCount() - 1 && !closed_;
        if ((first && along < 0) || (last && along > length))
        {
            continue;
        }
        const vector foot =
            points_[s] + std::min(std::max(along, 0.0), length)*t;
        const scalar magnitude = (point - foot).norm();
        const scalar side = d.dot(normal(s));
        const bool tie = std::abs(magnitude - best) <= 1e-12*length;
        if
        (
            (!tie && magnitude < best)
         || (tie && std::abs(side) > std::abs(bestSide))
        )
        {
            best = std::min(best, magnitude);
            bestSide = side;
        }
    }
    return bestSide < 0 ? -best : best;
}

std::vector<vector> Wall::offset(const scalar depth) const
{
    const label n = segmentCount();
    std::vector<vector> moved(points_.size());
    for (label v = 0; v <= n; ++v)
    {
        const label before = v > 0 ? v - 1 : (closed_ ? n - 1 : 0);
        const label after = v < n ? v : (closed_ ? 0 : n - 1);
        const vector a = normal(before), b = normal(after);
        // Mitre: the point at the given depth behind both segments
        moved[v] = points_[v] - depth/(1 + a.dot(b))*(a + b);
    }
    return moved;
}

std::vector<WallParticle> Wall::wallParticles() const
{
    const scalar dx = spacing();
    std::vector<WallParticle> particles;
    for (label layer = 0; layer < layers_; ++layer)
    {
        const scalar depth = (layer + 0.5)*dx;
        const std::vector<vector> line = offset(depth);
        for (label s = 0; s < segmentCount(); ++s)
        {
            const vector t = tangent(s);
            const scalar length = (line[s + 1] - line[s]).dot(t);
            // A side that a re-entrant corner has used up
            if (length <= 0)
            {
                continue;
            }
            const label n = std::max<label>(1, std::lround(length/dx));
            for (label i = 0; i < n; ++i)
            {
                const vector r = line[s] + (i + 0.5)*length/n*t;
                particles.push_back({r, normal(s), depth, -1});
            }
        }
    }
    return particles;
}

void Wall::check(const Particles&, const scalar reach) const
{
    // Rows lie (l + 1/2) dx deep; material comes as near as dx/4, and the skin
    // of the lists is about as wide
    const label needed = label(std::ceil(reach/spacing() - 1));
    if (layers_ < needed)
    {
        warning
        (
            "Wall " + name() + " has " + std::to_string(layers_)
          + " layers of particles, but the kernel reaches "
          + std::to_string(needed) + ": material near it sees a void.\n"
            "Give layers " + std::to_string(needed) + " in constant/boundary"
            " and run setParticles again."
        );
    }
}

label Wall::net(Particles& particles) const
{
    const scalar gap = 0.25*spacing();
    const scalar reach = 2*spacing();
    vectorField& r = particles.r;
    vectorField& U = particles.U;
    label hits = 0;
    for (label s = 0; s < segmentCount(); ++s)
    {
        const vector p = points_[s], t = tangent(s), n = normal(s);
        const scalar length = (points_[s + 1] - points_[s]).norm();
        const vector velocity = velocity_;
        #pragma omp parallel for schedule(static) reduction(+: hits)
        for (label i = 0; i < particles.awake().end; ++i)
        {
            const scalar dx = r.x[i] - p.x(), dy = r.y[i] - p.y();
            const scalar height = dx*n.x() + dy*n.y();
            if (height < gap && height > -reach)
            {
                const scalar along = dx*t.x() + dy*t.y();
                const bool here = along >= 0 && along <= length;
                if (here)
                {
                    r.x[i] += (gap - height)*n.x();
                    r.y[i] += (gap - height)*n.y();
                    const scalar Un =
                        (U.x[i] - velocity.x())*n.x()
                      + (U.y[i] - velocity.y())*n.y();
                    if (Un < 0)
                    {
                        U.x[i] -= Un*n.x();
                        U.y[i] -= Un*n.y();
                    }
                    ++hits;
                }
            }
        }
    }
    return hits;
}

} // namespace sph
