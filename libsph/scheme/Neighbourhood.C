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
    skin_(skin)
{
    for (const auto& patch : boundaries.patches())
    {
        reflections_.push_back(patch->reflection());
    }
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
        asleep[i] = asleep[images_[k].source];
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
    const label nMaterialImages = makeImages();
    grid_.build(particles_.r, {particles_.granular()}, cutOff_ + skin_);
    setOrder(nMaterialImages);
    particles_.reorderGranular(order_);
    rebuildsSinceSort_ = 0;
    mustSort_ = false;
}

// Positions of images from the given one on
void Neighbourhood::placeImages(const std::size_t first)
{
    vectorField& r = particles_.r;
    const label begin = particles_.ghosts().begin;
    for (std::size_t k = first; k < images_.size(); ++k)
    {
        const Image& image = images_[k];
        r.set
        (
            begin + label(k),
            reflections_[image.patch]*r[image.source] + image.shift
        );
    }
}

// Images by one patch of a range, and of its images that are there already,
// the first of which is given
void Neighbourhood::appendImages
(
    const ParticleRange& range, const std::size_t firstImage,
    const label patchI
)
{
    const Boundary& patch = *boundaries_.patches()[patchI];
    const scalar reach = cutOff_ + skin_;
    const label ghostBegin = particles_.ghosts().begin;
    const std::size_t before = images_.size();

    patch.makeImages(particles_.r, range.begin, range.end, reach, images_);
    patch.makeImages
    (
        particles_.r, ghostBegin + label(firstImage),
        ghostBegin + label(before), reach, images_
    );
    for (std::size_t k = before; k < images_.size(); ++k)
    {
        images_[k].patch = patchI;
    }
    particles_.resizeGhosts(label(images_.size()));
    placeImages(before);
    for (std::size_t k = before; k < images_.size(); ++k)
    {
        const label i = ghostBegin + label(k);
        particles_.m[i] = particles_.m[images_[k].source];
        particles_.id[i] = particles_.id[images_[k].source];
        particles_.patch[i] = particles_.patch[images_[k].source];
    }
}

// Images of the material first, then of the walls; returns how many are of
// the material
label Neighbourhood::makeImages()
{
    images_.clear();
    particles_.resizeGhosts(0);
    const label nPatches = label(boundaries_.patches().size());
    for (label patch = 0; patch < nPatches; ++patch)
    {
        appendImages(particles_.granular(), 0, patch);
    }
    const label nMaterial = label(images_.size());
    for (label patch = 0; patch < nPatches; ++patch)
    {
        appendImages(particles_.walls(), nMaterial, patch);
    }
    return nMaterial;
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
        placeImages(0);
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
            j = images_[j - ghosts].source;
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
    const label nMaterial = makeImages();

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

// One field: images of images come after their sources
void Neighbourhood::refreshImages(const FieldInfo& info)
{
    const label begin = particles_.ghosts().begin;
    const auto& c = info.components;
    for (std::size_t k = 0; k < images_.size(); ++k)
    {
        const label from = images_[k].source;
        const label to = begin + label(k);
        const tensor& R = reflections_[images_[k].patch];
        if (info.kind == FieldKind::scalar)
        {
            (*c[0])[to] = (*c[0])[from];
        }
        else if (info.kind == FieldKind::vector)
        {
            const vector v = R*vector((*c[0])[from], (*c[1])[from]);
            (*c[0])[to] = v.x();
            (*c[1])[to] = v.y();
        }
        else
        {
            const bool symmetric = info.kind == FieldKind::symmTensor;
            const label yx = symmetric ? 1 : 2, yy = symmetric ? 2 : 3;
            tensor t;
            t << (*c[0])[from], (*c[1])[from],
                 (*c[yx])[from], (*c[yy])[from];
            t = (R*t*R.transpose()).eval();
            (*c[0])[to] = t(0, 0);
            (*c[1])[to] = t(0, 1);
            (*c[yx])[to] = t(1, 0);
            (*c[yy])[to] = t(1, 1);
        }
    }
}

void Neighbourhood::refreshImages(const std::vector<const FieldInfo*>& fields)
{
    // Not worth a team of threads below
    constexpr std::size_t few = 200;
    #pragma omp parallel for schedule(dynamic) if(images_.size() > few)
    for (std::size_t k = 0; k < fields.size(); ++k)
    {
        refreshImages(*fields[k]);
    }
}

} // namespace sph
