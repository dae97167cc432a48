#include "corrections/Correction.H"

namespace sph
{

Correction::Correction(PairWalk& walk)
:
    particles_(walk.particles()),
    V_(walk.neighbour("V"))
{}

void Correction::evaluate(const PairBlock& block)
{
    symmTensorLanes M{0, 0, 0};
    for (label k = 0; k < block.n; ++k)
    {
        const vectorLanes r = block.r(k);
        const vectorLanes VFr = block.scalar(V_, k)*block.F(k)*r;
        M.xx -= VFr.x*r.x;
        M.xy -= VFr.x*r.y;
        M.yy -= VFr.y*r.y;
    }

    const lanes d = M.xx - M.yy;
    const lanes lambda =
        0.5*(M.xx + M.yy - sqrt(d*d + 4.0*M.xy*M.xy));
    symmTensorLanes L;
    lanes w;
    correct(M, lambda, L, w);

    store(lambda, &particles_.lambda[block.first]);
    store(w, &particles_.w[block.first]);
    store(L, particles_.L, block.first);
}

symmTensorLanes Correction::guardedInverse
(
    const symmTensorLanes& M, const lanes& lambda
)
{
    const lanes guard = max(0.25 - lambda, lanes(0));
    const lanes xx = M.xx + guard, yy = M.yy + guard;
    const lanes invDet = 1.0/(xx*yy - M.xy*M.xy);
    return {invDet*yy, -invDet*M.xy, invDet*xx};
}

} // namespace sph
