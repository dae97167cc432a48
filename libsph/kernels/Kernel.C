#include "kernels/Kernel.H"

namespace sph
{

scalar Kernel::W(const scalar r) const
{
    alignas(64) scalar rSqr[laneCount], F[laneCount], W[laneCount];
    std::fill_n(rSqr, laneCount, r*r);
    evaluateRows(1, rSqr, F, W);
    return W[0];
}

scalar Kernel::F(const scalar r) const
{
    alignas(64) scalar rSqr[laneCount], F[laneCount];
    std::fill_n(rSqr, laneCount, r*r);
    evaluateRows(1, rSqr, F, nullptr);
    return F[0];
}

} // namespace sph
