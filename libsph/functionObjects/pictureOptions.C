#include "functionObjects/pictureOptions.H"

#include "deposit/magnitude.H"

namespace sph
{

ParticlePicture::Options readPictureOptions
(
    const dictionary& dict, const Particles& particles
)
{
    ParticlePicture::Options options;
    options.field = dict.getOrDefault<word>
    (
        {"field", "field that colours the particles"}, "U"
    );
    findField(particles, options.field, dict, "field");
    const Key colours
    (
        "range", "range of the colours; else that of the values", "(0 0.5)"
    );
    if (dict.found(colours))
    {
        const auto range = dict.get<std::vector<scalar>>("range");
        if (range.size() != 2 || !(range[0] < range[1]))
        {
            dict.fail
            (
                "range", "The range of the colours is two numbers, the"
                " lower one first: (0 0.5)"
            );
        }
        options.range = std::make_pair(range[0], range[1]);
    }
    options.vectors =
        dict.getOrDefault({"vectors", "arrows of the velocity"}, false);
    const Key sliding
    (
        "slidingInterface", "line between what is slower and faster", "0.02"
    );
    if (dict.found(sliding))
    {
        options.slidingSpeed =
            dict.get("slidingInterface", dimVelocity, Range::positive());
    }
    return options;
}

} // namespace sph
