#include "runoutLaws/RunoutLaw.H"

#include <cmath>
#include <limits>
#include <sstream>

namespace sph
{

static const scalar unknown = std::numeric_limits<scalar>::quiet_NaN();


LawValue LawValue::none(const std::string& note)
{
    return {unknown, unknown, note};
}


static scalar valueOf(const PowerLaw& fit, const scalar a)
{
    return fit.coefficient*std::pow(a, fit.exponent);
}


static std::string text(const std::string& before, const scalar a)
{
    std::ostringstream os;
    os << before << a;
    return os.str();
}


RunoutLaw::RunoutLaw(const dictionary& dict)
:
    interpolate_
    (
        dict.getChoiceOrDefault
        (
            {"gap", "between the ranges of two fits"}, "interpolate",
            {"interpolate", "noLaw"}
        )
     == "interpolate"
    )
{}


LawValue RunoutLaw::evaluate
(
    const std::vector<PowerLaw>& fits, const scalar a
) const
{
    if (a < fits.front().aMin)
    {
        return LawValue::none(text("no law below a = ", fits.front().aMin));
    }
    const PowerLaw* below = nullptr;
    for (const PowerLaw& fit : fits)
    {
        if (a < fit.aMin)
        {
            const std::string gap =
                text("gap ", below->aMax) + text(" < a < ", fit.aMin);
            if (!interpolate_)
            {
                return LawValue::none("no law in the " + gap);
            }
            const scalar from = valueOf(*below, below->aMax);
            const scalar to = valueOf(fit, fit.aMin);
            const scalar exponent =
                std::log(to/from)/std::log(fit.aMin/below->aMax);
            return
            {
                from*std::pow(a/below->aMax, exponent),
                std::max(below->band, fit.band),
                "interpolated across the " + gap
            };
        }
        if (a <= fit.aMax)
        {
            return {valueOf(fit, a), fit.band, ""};
        }
        below = &fit;
    }
    return
    {
        valueOf(*below, a), below->band,
        text("beyond the data, a < ", below->aMax)
    };
}

} // namespace sph
