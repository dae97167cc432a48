// Corrected gradients (12)-(13); the divergence of the continuity takes them
// in the bulk only.
//
//     div U = w tr(L grad U) + (1 - w) tr(grad U),
//     w     = (lambda - lambda0)/(lambda1 - lambda0), between 0 and 1
//
// Corrected everywhere, the thin front falls through the floor; nowhere, flow
// on an incline bounces.
//
//     correction  bulkBlended;
//     bulkBlendedCoeffs { lambda0 0.6; lambda1 0.85; }

#include "corrections/Correction.H"

namespace sph
{
namespace
{

class bulkBlended : public Correction
{
    const scalar lambda0_;
    const scalar lambda1_;

public:
    explicit bulkBlended(const dictionary& dict)
    :
        lambda0_
        (
            dict.getOrDefault
            (
                {"lambda0", "lambda below which div U is not corrected"}, 0.6,
                dimless, Range::between(0, 1)
            )
        ),
        lambda1_
        (
            dict.getOrDefault
            (
                {"lambda1", "lambda above which it is, in full"}, 0.85,
                dimless, Range::between(0, 1)
            )
        )
    {
        if (lambda1_ <= lambda0_)
        {
            dict.fail("lambda1", "lambda1 must be greater than lambda0");
        }
    }

protected:
    void correct
    (
        const symmTensorLanes& M, const lanes& lambda,
        symmTensorLanes& L, lanes& w
    ) const override
    {
        L = guardedInverse(M, lambda);
        w = clamp
        (
            (lambda - lambda0_)/(lambda1_ - lambda0_), lanes(0), lanes(1)
        );
    }
};

static const Correction::Add<bulkBlended> add
(
    "bulkBlended", "corrected gradients; divergence corrected in the bulk only"
);

} // namespace
} // namespace sph
