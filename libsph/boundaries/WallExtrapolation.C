#include "boundaries/WallExtrapolation.H"

#include "pairs/FusedSums.H"

namespace sph
{

static const FusedSums::Add<WallStress, WallVelocityGradient> stress;

template class PairSum<WallViscosity>;

WallVelocity::WallVelocity(Particles& particles, const Boundaries& boundaries)
:
    particles_(particles),
    boundaries_(boundaries)
{}

static alignedList<WallPairs::Row>& rowsOfThread()
{
    static thread_local alignedList<WallPairs::Row> rows(64);
    return rows;
}

void WallVelocity::addRow(const label k, const WallPairs::Row& row)
{
    auto& rows = rowsOfThread();
    if (k >= label(rows.size()))
    {
        rows.resize(2*rows.size());
    }
    rows[k] = row;
}

void WallVelocity::setVelocity
(
    const label first, const label size, const vectorLanes& n,
    const lanes& depth, const lanes& invSumVW
) const
{
    const WallPairs pairs{rowsOfThread().data(), size, n, depth, invSumVW};

    // The patches met among these particles, each asked once
    label done = -1;
    for (label lane = 0; lane < width<lanes>; ++lane)
    {
        const label patch = particles_.patch[first + lane];
        if (patch <= done)
        {
            continue;
        }
        done = patch;
        const vectorLanes U =
            boundaries_.patches()[patch]->wallVelocity(pairs);
        for (label other = lane; other < width<lanes>; ++other)
        {
            if (particles_.patch[first + other] == patch)
            {
                particles_.U.x[first + other] = U.x[other];
                particles_.U.y[first + other] = U.y[other];
            }
        }
    }
}

WallStress::WallStress
(
    Particles& particles, const Boundaries& boundaries,
    const EquationOfState& eos, const vector& g
)
:
    particles_(particles),
    boundaries_(boundaries),
    eos_(eos),
    g_(g)
{}

// Calls mirrored(w, reflection) for those particles whose patch asks for it
template<class Mirrored>
static void forEachMirrored
(
    const Particles& particles, const Boundaries& boundaries,
    const label first, const Mirrored& mirrored
)
{
    for (label w = first; w < first + width<lanes>; ++w)
    {
        const label patch = particles.patch[w];
        if (patch >= 0 && boundaries.patches()[patch]->mirrorsStress())
        {
            const vector n = particles.n[w];
            mirrored(w, tensor(tensor::Identity() - 2*n*n.transpose()));
        }
    }
}

void WallStress::setDensity(const label first) const
{
    for (label w = first; w < first + width<lanes>; ++w)
    {
        if (particles_.patch[w] >= 0)
        {
            particles_.rho[w] = eos_.density(particles_.p[w]);
            particles_.V[w] = particles_.m[w]/particles_.rho[w];
        }
    }
    forEachMirrored
    (
        particles_, boundaries_, first,
        [&](const label w, const tensor& R)
        {
            particles_.s.set(w, R*particles_.s[w]*R);
        }
    );
}

WallVelocityGradient::WallVelocityGradient
(
    Particles& particles, const Boundaries& boundaries
)
:
    particles_(particles),
    boundaries_(boundaries)
{}

void WallVelocityGradient::mirror(const label first) const
{
    forEachMirrored
    (
        particles_, boundaries_, first,
        [&](const label w, const tensor& R)
        {
            particles_.gradU.set(w, R*particles_.gradU[w]*R);
        }
    );
}

} // namespace sph
