#include "advice/MeasuredScene.H"

#include "dictionary/files.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

scalar MeasuredRun::worst() const
{
    return
        front
      ? std::max(std::abs(*front), std::abs(height.value_or(0)))
      : error;
}


static std::optional<scalar> readOptional
(
    const dictionary& dict, const word& key
)
{
    if (!dict.found(key))
    {
        return {};
    }
    return dict.get<scalar>(key);
}

MeasuredScene::MeasuredScene(const word& name, const dictionary& dict)
:
    name_(name),
    kind_(dict.getChoice("kind", {"column", "incline", "liquid"})),
    aspect_(dict.get("aspect", dimless, Range::positive())),
    duration_(dict.get("duration", dimless, Range::positive())),
    reference_(dict.get<word>("reference"))
{
    for (const auto& [ignored, run] : dict.dictList("runs"))
    {
        runs_.push_back
        (
            {
                run->get<word>("setting"),
                run->getLabel("across", Range{1}),
                run->getLabel("particles", Range{1}),
                run->get("time", dimless, Range::positive()),
                run->get("error", dimless, Range::nonNegative()),
                readOptional(*run, "front"), readOptional(*run, "height")
            }
        );
    }
    std::stable_sort
    (
        runs_.begin(), runs_.end(),
        [](const MeasuredRun& a, const MeasuredRun& b)
        {
            return a.across < b.across;
        }
    );
}

scalar MeasuredScene::distance(const CaseScene& scene) const
{
    if (scene.kind != kind_)
    {
        return std::numeric_limits<scalar>::infinity();
    }
    return
        kind_ == "incline" ? 0 : std::abs(std::log(scene.aspect()/aspect_));
}

// Steps go as the duration and the number across, which are equal here
scalar MeasuredScene::timeOf
(
    const CaseScene& scene, const MeasuredRun& run
) const
{
    return run.time*scene.particles(run.across)/run.particles
        *scene.duration/duration_;
}

const MeasuredRun* MeasuredScene::coarsestWithin
(
    const word& setting, const scalar error
) const
{
    const MeasuredRun* coarsest = nullptr;
    for (const MeasuredRun& run : runs_)
    {
        if (run.setting == setting)
        {
            coarsest =
                run.worst() > error ? nullptr : coarsest ? coarsest : &run;
        }
    }
    return coarsest;
}

std::vector<MeasuredScene> readMeasuredScenes()
{
    const auto dict =
        dictionary::fromFile(etcFolder()/"charts"/"measured");
    std::vector<MeasuredScene> scenes;
    for (const word& name : dict.toc())
    {
        if (name != "FoamFile")
        {
            scenes.emplace_back(name, dict.subDict(name));
        }
    }
    dict.refuseUnused();
    return scenes;
}

} // namespace sph
