// No law: the deposit is measured and compared with nothing.
//
//     law  none;

#include "runoutLaws/RunoutLaw.H"

namespace sph
{
namespace
{

class none : public RunoutLaw
{
public:
    explicit none(const dictionary& dict)
    :
        RunoutLaw(dict)
    {}

    LawValue runout(scalar) const override { return LawValue::none(""); }
    LawValue height(scalar) const override { return LawValue::none(""); }
    LawValue stopTime(scalar) const override { return LawValue::none(""); }
};

const RunoutLaw::Add<none> add("none", "nothing to compare with");

} // namespace
} // namespace sph
