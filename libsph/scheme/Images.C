#include "scheme/Images.H"

#include "particles/worthATeam.H"

namespace sph
{

Images::Images
(
    Particles& particles, const Boundaries& boundaries, const scalar reach
)
:
    particles_(particles),
    boundaries_(boundaries),
    reach_(reach)
{
    for (const auto& patch : boundaries.patches())
    {
        reflections_.push_back(patch->reflection());
    }
}

// Positions of images from the given one on
void Images::place(const std::size_t first)
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
void Images::append
(
    const ParticleRange& range, const std::size_t firstImage,
    const label patchI
)
{
    const Boundary& patch = *boundaries_.patches()[patchI];
    const label ghostBegin = particles_.ghosts().begin;
    const std::size_t before = images_.size();

    patch.makeImages(particles_.r, range.begin, range.end, reach_, images_);
    patch.makeImages
    (
        particles_.r, ghostBegin + label(firstImage),
        ghostBegin + label(before), reach_, images_
    );
    for (std::size_t k = before; k < images_.size(); ++k)
    {
        images_[k].patch = patchI;
    }
    particles_.resizeGhosts(label(images_.size()));
    place(before);
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
label Images::make()
{
    images_.clear();
    particles_.resizeGhosts(0);
    const label nPatches = label(boundaries_.patches().size());
    for (label patch = 0; patch < nPatches; ++patch)
    {
        append(particles_.granular(), 0, patch);
    }
    const label nMaterial = label(images_.size());
    for (label patch = 0; patch < nPatches; ++patch)
    {
        append(particles_.walls(), nMaterial, patch);
    }
    return nMaterial;
}

// One field: images of images come after their sources
void Images::refresh(const FieldInfo& info)
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

void Images::refresh(const std::vector<const FieldInfo*>& fields)
{
    #pragma omp parallel for schedule(dynamic) \
        if(worthATeam(label(images_.size())))
    for (std::size_t k = 0; k < fields.size(); ++k)
    {
        refresh(*fields[k]);
    }
}

} // namespace sph
