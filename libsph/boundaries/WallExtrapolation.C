#include "boundaries/WallExtrapolation.H"

namespace sph
{

// 1/sum V W, 0 where a wall particle faces no material
static lanes inverseShepardSum(const PairBlock& block, const PairWalk::Slot V)
{
    lanes sum = 0;
    for (label k = 0; k < block.n; ++k)
    {
        sum += block.scalar(V, k)*block.W(k);
    }
    return select(sum > 1e-12, 1.0/max(sum, lanes(1e-12)), lanes(0));
}

WallVelocity::WallVelocity(PairWalk& walk, const Boundaries& boundaries)
:
    particles_(walk.particles()),
    boundaries_(boundaries),
    V_(walk.neighbour("V")),
    U_(walk.neighbour("U"))
{
    walk.needsW();
}

void WallVelocity::evaluate(const PairBlock& block)
{
    const label first = block.first;
    const WallPairs pairs
    {
        block, V_, U_, load(particles_.n, first),
        load(&particles_.depth[first]), inverseShepardSum(block, V_)
    };

    // The patches met among these particles, each asked once
    label done = -1;
    for (label lane = 0; lane < laneCount; ++lane)
    {
        const label patch = particles_.patch[first + lane];
        if (patch <= done)
        {
            continue;
        }
        done = patch;
        const vectorLanes U =
            boundaries_.patches()[patch]->wallVelocity(pairs);
        for (label other = lane; other < laneCount; ++other)
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
    PairWalk& walk, const Boundaries& boundaries,
    const EquationOfState& eos, const vector& g,
    const bool needsEta, const bool needsGradU
)
:
    particles_(walk.particles()),
    boundaries_(boundaries),
    eos_(eos),
    g_(g),
    needsEta_(needsEta),
    needsGradU_(needsGradU),
    V_(walk.neighbour("V")),
    rho_(walk.neighbour("rho")),
    p_(walk.neighbour("p")),
    q_(walk.neighbour("q")),
    s_(walk.neighbour("s"))
{
    walk.needsW();
    if (needsEta_)
    {
        eta_ = walk.neighbour("eta");
    }
    if (needsGradU_)
    {
        gradU_ = walk.neighbour("gradU");
    }
}

void WallStress::evaluate(const PairBlock& block)
{
    const label i = block.first;
    const lanes invSum = inverseShepardSum(block, V_);

    lanes p = 0, q = 0, eta = 0;
    symmTensorLanes s{0, 0, 0};
    tensorLanes gradU{0, 0, 0, 0};
    const vectorLanes g{g_.x(), g_.y()};
    for (label k = 0; k < block.n; ++k)
    {
        const lanes VW = invSum*block.scalar(V_, k)*block.W(k);
        p += VW
            *(block.scalar(p_, k) + block.scalar(rho_, k)*(g & block.r(k)));
        q += VW*block.scalar(q_, k);
        const symmTensorLanes sj = block.symmTensor(s_, k);
        s = s + symmTensorLanes{VW*sj.xx, VW*sj.xy, VW*sj.yy};
        if (needsEta_)
        {
            eta += VW*block.scalar(eta_, k);
        }
        if (needsGradU_)
        {
            const tensorLanes G = block.tensor(gradU_, k);
            gradU += tensorLanes{VW*G.xx, VW*G.xy, VW*G.yx, VW*G.yy};
        }
    }
    p = max(p, lanes(0));

    store(p, &particles_.p[i]);
    store(q, &particles_.q[i]);
    store(s, particles_.s, i);
    if (needsEta_)
    {
        store(eta, &particles_.eta[i]);
    }
    if (needsGradU_)
    {
        store(gradU, particles_.gradU, i);
    }

    for (label w = i; w < i + laneCount; ++w)
    {
        if (particles_.patch[w] < 0)
        {
            continue;
        }
        particles_.rho[w] = eos_.density(particles_.p[w]);
        particles_.V[w] = particles_.m[w]/particles_.rho[w];
        if (boundaries_.patches()[particles_.patch[w]]->mirrorsStress())
        {
            const vector n = particles_.n[w];
            const tensor R = tensor::Identity() - 2*n*n.transpose();
            particles_.s.set(w, R*particles_.s[w]*R);
            particles_.gradU.set(w, R*particles_.gradU[w]*R);
        }
    }
}

} // namespace sph
