// A picture of the particles, coloured by a field: image_<time>.png
//
//     image
//     {
//         type    image;
//         when    end;        // end: of the run; execute: at every call
//         ...                 // functionObjects/pictureOptions.H
//     }
//
// gnuplot draws it; script and data stay beside the picture. Without gnuplot
// there is a warning, and the run goes on.

#include "functionObjects/DataFile.H"
#include "functionObjects/FunctionObject.H"
#include "functionObjects/pictureOptions.H"

namespace sph
{
namespace
{

class image : public FunctionObject
{
    const Particles& particles_;
    const ParticlePicture::Options options_;
    bool atEnd_;
    OutputFolder folder_;
    scalar time_ = 0;

public:
    image(const dictionary& dict, const word& name, const Scene& scene)
    :
        particles_(scene.particles),
        options_(readPictureOptions(dict, scene.particles)),
        atEnd_
        (
            dict.getChoiceOrDefault
            (
                {"when", "at the end of the run, or at every call"},
                "end", {"end", "execute"}
            )
         == "end"
        ),
        folder_(scene.caseDir, name, scene.startTimeName)
    {
        findField(scene, options_.field, dict, "field");
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
