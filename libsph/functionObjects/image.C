// A picture of the particles, coloured by a field: image_<time>.png
//
//     image
//     {
//         type    image;
//         field   U;          // any field of the particles, by magnitude
//         when    end;        // end: of the run; execute: at every call
//         range   (0 0.5);    // of the colours; default from the values
//     }
//
// gnuplot draws it; script and data stay beside the picture. Without gnuplot
// there is a warning, and the run goes on.

#include "deposit/magnitude.H"
#include "functionObjects/DataFile.H"
#include "functionObjects/FunctionObject.H"
#include "functionObjects/ParticlePicture.H"

namespace sph
{
namespace
{

class image : public FunctionObject
{
    const Particles& particles_;
    ParticlePicture::Options options_;
    bool atEnd_;
    OutputFolder folder_;
    scalar time_ = 0;

public:
    image(const dictionary& dict, const word& name, const Scene& scene)
    :
        particles_(scene.particles),
        atEnd_
        (
            dict.getChoiceOrDefault("when", "end", {"end", "execute"}) == "end"
        ),
        folder_(scene.caseDir, name, scene.startTimeName)
    {
        options_.field = dict.getOrDefault<word>("field", "U");
        findField(particles_, options_.field, dict, "field");
        if (dict.found("range"))
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
            options_.range = std::make_pair(range[0], range[1]);
        }
    }

    void execute(const scalar time, std::string&) override
    {
        time_ = time;
        if (!atEnd_)
        {
            draw();
        }
    }

    void end() override
    {
        if (atEnd_)
        {
            draw();
        }
    }

private:
    void draw()
    {
        ParticlePicture picture(options_);
        const std::string time = shortText(time_);
        picture.addPanel(particles_, "t = " + time + " s");
        picture.write(folder_.path(), "image_" + time);
    }
};

static const FunctionObject::Add<image> add
(
    "image", "picture (PNG) of the particles, coloured by a field"
);

} // namespace
} // namespace sph
