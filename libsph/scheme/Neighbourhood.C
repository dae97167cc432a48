#include "scheme/Neighbourhood.H"

#include <algorithm>

namespace sph
{

Neighbourhood::Neighbourhood
(
    Particles& particles, const Boundaries& boundaries,
    const scalar cutOff, const scalar skin
)
:
    particles_(particles),
    boundaries_(boundaries),
    cutOff_(cutOff),
    skin_(skin),
    images_(particles, boundaries, cutOff + skin)
{
    boundaries.check(particles, cutOff + skin);
}

// Those that are awake first, then sleepers in cells beside theirs, then the
// others; each in the order of the cells
void Neighbourhood::setOrder(const label nMaterialImages)
{
    const scalarField& asleep = particles_.asleep;
    const label n = particles_.granular().end;
    findNearAwake(nMaterialImages);
    if (fillAwakeSlice())
    {
        findNearAwake(nMaterialImages);
    }

    order_.clear();
    const auto append = [&](const auto& condition)
    {
        for (label k = 0; k < n; ++k)
        {
            const label i = grid_.particles()[k];
            if (condition(i))
            {
                order_.push_back(i);
            }
        }
        return label(order_.size());
    };
    const auto watches = [&](const label i)
    {
        return asleep[i] == 1 && nearAwake_[grid_.cells()[i]];
    };
    const label nAwake = append([&](const label i) { return asleep[i] < 1; });
    const label nActive = append(watches);
    append([&](const label i) { return asleep[i] == 1 && !watches(i); });
    particles_.setAwake(nAwake, nActive);
}

// Flags the cells of particles and images that are awake, and those around
void Neighbourhood::findNearAwake(const label nMaterialImages)
{
    scalarField& asleep = particles_.asleep;
    nearAwake_.assign(std::size_t(grid_.nx())*grid_.ny(), false);
    for (label i = 0; i < particles_.granular().end; ++i)
    {
        nearAwake_[grid_.cells()[i]] |= asleep[i] < 1;
    }
    for (label k = 0; k < nMaterialImages; ++k)
    {
        const label i = particles_.ghosts().begin + k;
        const vector r = particles_.r[i];
        asleep[i] = asleep[images_.all()[k].source];
        nearAwake_[grid_.cellOf(r.x(), r.y())] |= asleep[i] < 1;
    }
    grid_.dilate(nearAwake_);
}

// Makes sleepers beside others that are awake drowsy, so that these fill whole
// slices; returns whether there was anything to do
bool Neighbourhood::fillAwakeSlice()
{
    scalarField& asleep = particles_.asleep;
    const label n = particles_.granular().end;
    const label nAwake = label
    (
        std::count_if
        (
            asleep.begin(), asleep.begin() + n,
            [](const scalar a) { return a < 1; }
        )
    );
    label missing = roundUpToLanes(nAwake) - nAwake;
    const bool any = missing > 0 && nAwake < n;
    for (const bool near : {true, false})
    {
        for (label k = 0; k < n && missing > 0; ++k)
        {
            const label i = grid_.particles()[k];
            if
            (
                asleep[i] == 1
             && (!near || nearAwake_[grid_.cells()[i]])
            )
            {
                asleep[i] = 0.5;
                particles_.Umean.set(i, vector::Zero());
                --missing;
            }
        }
    }
    return any;
}

// Rows of cells keep what is near in space near in memory
void Neighbourhood::sortGranular()
{
    // Sleepers watch images, too
    const label nMaterialImages = images_.make();
    grid_.build(particles_.r, {particles_.granular()}, cutOff_ + skin_);
    setOrder(nMaterialImages);
    particles_.reorderGranular(order_);
    rebuildsSinceSort_ = 0;
    mustSort_ = false;
}

void Neighbourhood::prepare()
{
    if (mustSort_)
    {
        rebuild();
    }
}

bool Neighbourhood::update()
{
    if (!mustSort_)
    {
        images_.place();
        if (gauge_.complete(particles_.r, grid_, cutOff_, skin_))
        {
            return false;
        }
    }
    rebuild();
    return true;
}

void Neighbourhood::rebuild()
{
    for (const auto& patch : boundaries_.patches())
    {
        patch->wrap(particles_);
    }
    if (mustSort_ || ++rebuildsSinceSort_ >= 10)
    {
        sortGranular();
    }
    buildLists();
    if (anyUnseen())
    {
        sortGranular();
        buildLists();
    }
    ++rebuilds_;
}

// Whether somebody awake has come near sleepers that do not watch
bool Neighbourhood::anyUnseen() const
{
    const ParticleRange sound
        {particles_.active().end, particles_.granular().end};
    const label ghosts = particles_.ghosts().begin;
    const auto unseen = [&](label j)
    {
        if (j >= ghosts && j < particles_.null())
        {
            j = images_.all()[j - ghosts].source;
        }
        return j >= sound.begin && j < sound.end;
    };
    const auto& slices = granularPairs_.slices();
    return sound.size() > 0 && std::any_of
    (
        slices.begin(),
        slices.begin() + particles_.awake().size()/laneCount,
        [&](const PairList::Slice& slice)
        {
            return std::any_of
            (
                slice.rows, slice.rows + slice.n*laneCount, unseen
            );
        }
    );
}

void Neighbourhood::buildLists()
{
    const label nMaterial = images_.make();

    const ParticleRange granular = particles_.granular();
    const ParticleRange walls = particles_.walls();
    const ParticleRange ghosts = particles_.ghosts();
    const ParticleRange material[2] =
        {granular, {ghosts.begin, ghosts.begin + nMaterial}};
    const ParticleRange all[2] = {{0, particles_.null()}, {0, 0}};
    const scalar reach = cutOff_ + skin_;

    grid_.build(particles_.r, {granular, walls, ghosts}, reach);
    granularPairs_.build
    (
        particles_.r, particles_.active(), grid_, all, reach,
        particles_.null()
    );
    wallPairs_.build
    (
        particles_.r, walls, grid_, material, reach, particles_.null()
    );
    gauge_.reset(particles_.r, {granular, walls, ghosts});
}

} // namespace sph
