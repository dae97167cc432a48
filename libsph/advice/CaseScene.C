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
    if (g.norm() == 0 || bounds.isEmpty())
    {
        throw Error("Advice needs gravity and a region of particles");
    }
    const Material material(properties, g, scene.spacing);
    const Boundaries boundaries(boundary, scene.spacing);

    scene.height = bounds.sizes().y();
    scene.length = bounds.sizes().x();
    const scalar middle = bounds.center().y();
    if
    (
        !held(boundaries, {bounds.min().x(), middle}, scene.spacing)
     && !held(boundaries, {bounds.max().x(), middle}, scene.spacing)
    )
    {
        scene.length /= 2;
    }
    scene.slope = std::atan2(std::abs(g.x()), std::abs(g.y()));
    scene.slow = material.rheology().friction(0);
    scene.fast = material.rheology().friction(1e6);
    scene.kind =
        !scene.slow ? "liquid" : periodic(boundary) ? "incline" : "column";
    scene.KFactor =
        material.eos().K()/(material.rho0()*g.norm()*scene.height);
    if (!std::isfinite(controls.endTime))
    {
        throw Error("Advice needs an endTime");
    }
    scene.duration = (controls.endTime - controls.startTime)
        /std::sqrt(scene.height/g.norm());
    return scene;
}

} // namespace sph
