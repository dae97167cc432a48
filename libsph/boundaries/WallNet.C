// The last net of a wall: a line dx/4 in front of it that nothing passes.
#include "boundaries/Wall.H"

#include <algorithm>

namespace sph
{

// Nets of both segments meet at the corner of the line
void Wall::holdAtCorner(const label point, Hold& hold) const
{
    const auto [before, after] = corner(point);
    hold.r = netLine_[point];
    hold.normals[0] = normal(before);
    hold.normals[1] = normal(after);
    hold.count = 2;
}

// Whether the net catches a point, relative to the wall as it was drawn
bool Wall::hold(const vector& point, Hold& hold) const
{
    const scalar gap = 0.25*spacing();
    const Foot foot = this->foot(point, nearSides_.of(point));
    // What stands on the net is not caught again for its rounding
    const scalar least = (1 - 1e-9)*gap;
    if (!(foot.distance < least && foot.distance > -2*spacing()))
    {
        return false;
    }
    const label s = foot.segment;
    const vector& t = tangent(s);
    const bool inner[2] = {turn(s) > 1e-9, turn(s + 1) > 1e-9};
    const scalar begin = inner[0] ? (netLine_[s] - points_[s]).dot(t) : 0;
    const scalar end =
        inner[1] ? (netLine_[s + 1] - points_[s]).dot(t) : length(s);
    if (inner[0] && foot.along < begin)
    {
        holdAtCorner(s, hold);
    }
    else if (inner[1] && foot.along > end)
    {
        holdAtCorner(s + 1, hold);
    }
    else if (foot.along < begin || foot.along > end)
    {
        // Round an edge
        const vector& edge = points_[foot.along < begin ? s : s + 1];
        hold.normals[0] = (point - edge).normalized();
        hold.r = edge + gap*hold.normals[0];
        hold.count = 1;
    }
    else
    {
        const vector n = normal(s);
        hold.normals[0] = n;
        hold.r = point + (gap - (point - points_[s]).dot(n))*n;
        hold.count = 1;
    }
    return true;
}

// Whether a side is to look at a point: corners hold what has passed beside
// the sides
bool Wall::looksAt(const label side, const vector& point) const
{
    const scalar reach = 2*spacing();
    const vector d = point - points_[side];
    const scalar height = d.dot(normal(side)), along = d.dot(tangent(side));
    const bool first = side == 0 && !closed_;
    const bool last = side == segmentCount() - 1 && !closed_;
    return
        height < 0.25*spacing() && height > -reach
     && along >= (first ? 0 : -reach)
     && along <= length(side) + (last ? 0 : reach);
}

label Wall::net(Particles& particles, const ParticleRange& range) const
{
    const vector velocity = this->velocity();
    const vector displacement = displacement_;
    label hits = 0;
    for (label i = range.begin; i < range.end; ++i)
    {
        vector r = particles.r[i] - displacement;
        NearSides::Range sides = nearSides_.of(r);
        for (const label* s = sides.begin(); s != sides.end(); )
        {
            Hold held;
            const label side = *s++;
            if (looksAt(side, r) && hold(r, held))
            {
                r = held.r;
                particles.r.set(i, r + displacement);
                const vector U = particles.U[i] - velocity;
                particles.U.set(i, velocity + held.allowed(U));
                ++hits;
                sides = nearSides_.of(r);
                s = std::upper_bound(sides.begin(), sides.end(), side);
            }
        }
    }
    return hits;
}

// Without what goes against a normal; between two sides that close in, at rest
vector Wall::Hold::allowed(vector U) const
{
    for (label k = 0; k < count; ++k)
    {
        U -= std::min(U.dot(normals[k]), 0.0)*normals[k];
    }
    const bool still = count == 2 && U.dot(normals[0]) < -1e-9*U.norm();
    return still ? vector(vector::Zero()) : U;
}

} // namespace sph
