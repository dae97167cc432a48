// An upright rectangle.
//
//     type box;  min (0 0 0);  max (0.1 0.2 0);
//
// min   the corner with the least x and y [m]
// max   the corner with the greatest x and y [m]

#include "regions/Outline.H"

namespace sph
{
namespace
{

class box : public Outline
{
    static std::vector<vector> corners(const dictionary& dict)
    {
        const vector min = dict.getVector
        (
            {"min", "corner with the least x and y", "(0 0 0)"}, dimLength
        );
        const vector max = dict.getVector
        (
            {"max", "corner with the greatest x and y", "(0.1 0.1 0)"},
            dimLength
        );
        for (const label d : {0, 1})
        {
            if (!(min[d] < max[d]))
            {
                dict.fail
                (
                    "max",
                    "The box is empty: max must be greater than min in "
                  + std::string(1, "xy"[d])
                );
            }
        }
        return {min, {max.x(), min.y()}, max, {min.x(), max.y()}};
    }

public:
    explicit box(const dictionary& dict)
    :
        Outline(corners(dict))
    {}
};

static const Region::Add<box> add("box", "upright rectangle: min, max");

} // namespace
} // namespace sph
