// Plain kernel gradients.
//
//     correction  none;

#include "corrections/Correction.H"

namespace sph
{
namespace
{

class uncorrected : public Correction
{
public:
    explicit uncorrected(const dictionary&)
    {}

    bool isExact() const override { return false; }

protected:
    void correct
    (
        const symmTensorLanes&, const lanes&, symmTensorLanes& L, lanes& w
    ) const override
    {
        L = {1, 0, 1};
        w = 0;
    }
};

static const Correction::Add<uncorrected> add
(
    "none", "plain kernel gradients"
);

} // namespace
} // namespace sph
