// Gradients that are exact for linear fields, everywhere.
//
//     grad W -> L grad W,   L = M^-1                              (12)-(13)
//
// Salehizadeh & Shafiei, Granular Matter 21:32 (2019). At a thin front the
// corrected divergence lets particles fall through a wall: bulkBlended.
//
//     correction  kernelGradient;

#include "corrections/Correction.H"

namespace sph
{
namespace
{

class kernelGradient : public Correction
{
public:
    explicit kernelGradient(const dictionary&)
    {}

protected:
    void correct
    (
        const symmTensorLanes& M, const lanes& lambda,
        symmTensorLanes& L, lanes& w
    ) const override
    {
        L = guardedInverse(M, lambda);
        w = 1;
    }
};

static const Correction::Add<kernelGradient> add
(
    "kernelGradient", "gradients exact for linear fields, Eqs. 12-13"
);

} // namespace
} // namespace sph
