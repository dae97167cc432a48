#include "advice/CaseScene.H"

#include "boundaries/Boundaries.H"
#include "regions/Region.H"
#include "runTime/TimeControls.H"
#include "scheme/Material.H"
#include "selection/Libraries.H"
#include "setup/Lattice.H"
#include "setup/readGravity.H"

#include <cmath>

namespace sph
{

namespace
{

// Whether a wall or a plane stands at this point
bool held(const Boundaries& boundaries, const vector& r, const scalar spacing)
{
    return std::abs(boundaries.distance(r).first) < spacing;
}

bool periodic(const dictionary& boundary)
{
    for (const word& patch : boundary.toc())
    {
        if
        (
            boundary.isDict(patch)
         && boundary.subDict(patch).getOrDefault<word>("type", "") == "periodic"
        )
        {
            return true;
        }
    }
    return false;
}

} // namespace


CaseScene readCaseScene(const std::filesystem::path& caseDir)
{
    const auto controlDict =
        dictionary::fromFile(caseDir/"system"/"controlDict");
    const TimeControls controls(controlDict);
    loadLibraries(controlDict, caseDir);
    const auto setup =
        dictionary::fromFile(caseDir/"system"/"setParticlesDict");
    const auto boundary =
        dictionary::fromFile(caseDir/"constant"/"boundary");
    const auto properties =
        dictionary::fromFile(caseDir/"constant"/"granularProperties");
    const vector g = readGravity(caseDir);

    CaseScene scene;
    scene.spacing = Lattice(setup).spacing();
    Region::Bounds bounds;
    scene.area = 0;
    for (const auto& [name, dict] : setup.dictList("regions"))
    {
        const auto region = Region::New(*dict);
        bounds.extend(region->bounds());
        scene.area += region->area();
    }
    if (bounds.isEmpty())
    {
        setup.fail("regions", "Advice needs a region of particles");
    }
    if (g.norm() == 0)
    {
        throw Error("Advice needs gravity: constant/g is 0");
    }
    const Material material(properties, g, scene.spacing);
    const Boundaries boundaries(boundary, scene.spacing);

    scene.height = bounds.sizes().y();
    scene.length = bounds.sizes().x();
    scene.slow = material.rheology().friction(0);
    scene.fast = material.rheology().friction(1e6);
    const auto law = properties.get<word>("rheology");
    scene.kind =
        scene.slow ? (periodic(boundary) ? "incline" : "column")
      : law == "Newtonian" ? "liquid" : "other";
    const scalar middle = bounds.center().y();
    if
    (
        scene.kind != "incline"
     && !held(boundaries, {bounds.min().x(), middle}, scene.spacing)
     && !held(boundaries, {bounds.max().x(), middle}, scene.spacing)
    )
    {
        scene.length /= 2;
    }
    scene.slope = std::atan2(std::abs(g.x()), std::abs(g.y()));
    scene.falls = !held
    (
        boundaries, {bounds.center().x(), bounds.min().y()}, 2*scene.spacing
    );
    scene.KFactor =
        material.eos().K()/(material.rho0()*g.norm()*scene.height);
    scene.linearKFactor =
        properties.get<word>("equationOfState") == "linear"
     && properties.optionalSubDict("linearCoeffs").found("KFactor");
    if (!std::isfinite(controls.endTime))
    {
        controlDict.fail("stopAt", "Advice needs a run with an endTime");
    }
    scene.duration = (controls.endTime - controls.startTime)
        /std::sqrt(scene.height/g.norm());
    return scene;
}

} // namespace sph
