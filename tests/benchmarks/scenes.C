#include "benchmarks/scenes.H"

#include <malloc.h>

#include <cmath>
#include <functional>
#include <map>

namespace sph
{

static constexpr label nr = 105;

static std::map<label, scalar> bytes;

static void run(CollapseScene& scene, const label steps)
{
    for (label step = 0; step < steps; ++step)
    {
        scene.step();
    }
}

static scalar allocatedBytes()
{
    const struct mallinfo2 info = mallinfo2();
    return scalar(info.uordblks + info.hblkhd);
}

// Makes a scene and counts its memory
static std::unique_ptr<CollapseScene> make
(
    const label k, const std::function<void(CollapseScene&)>& prepare
)
{
    const scalar before = allocatedBytes();
    auto scene = std::make_unique<CollapseScene>(k*nr);
    prepare(*scene);
    bytes[k] = (allocatedBytes() - before)/scene->size();
    return scene;
}

CollapseScene& midCollapse(const label k)
{
    static std::map<label, std::unique_ptr<CollapseScene>> scenes;
    auto& scene = scenes[k];
    if (scene)
    {
        return *scene;
    }
    if (k == 1)
    {
        scene = make(k, [](CollapseScene& s) { run(s, 22*nr); });
        scene->start(scene->state());
    }
    else
    {
        const auto state = midCollapse().refined(k);
        scene = make
        (
            k,
            [&](CollapseScene& s)
            {
                s.start(state);
                run(s, 50);
            }
        );
    }
    return *scene;
}

CollapseScene& midCollapse
(
    const std::string& name, const CollapseScene::Changes& changes
)
{
    static std::map<std::string, std::unique_ptr<CollapseScene>> scenes;
    auto& scene = scenes[name];
    if (!scene)
    {
        const auto state = midCollapse().state();
        scene = std::make_unique<CollapseScene>(nr, changes);
        scene->start(state);
    }
    return *scene;
}

CollapseScene& pausedCollapse()
{
    CollapseScene& scene = midCollapse("paused", {});
    if (scene.steps() == 0)
    {
        run(scene, 35);
    }
    return scene;
}

scalar bytesPerParticle(const label k)
{
    return bytes.count(k) ? bytes[k] : std::nan("");
}

} // namespace sph
