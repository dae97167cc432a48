#include "scheme/Images.H"

#include "particles/team.H"

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
{}

// Of what a patch has just appended
void Images::addRun(const label begin, const label patchI)
{
    const label end = label(images_.size());
    for (label k = begin; k < end; ++k)
    {
        Image& image = images_[k];
        image.patch = patchI;
        sources_.push_back(image.source);
        shifts_.x.push_back(image.shift.x());
        shifts_.y.push_back(image.shift.y());
    }
    const tensor reflection = boundaries_.patches()[patchI]->reflection();
    runs_.push_back({begin, end, reflection});
}

// Positions of images from the given run on
void Images::place(const std::size_t firstRun)
{
    scalar* x = particles_.r.x.data();
    scalar* y = particles_.r.y.data();
    const label ghosts = particles_.ghosts().begin;
    for (std::size_t k = firstRun; k < runs_.size(); ++k)
    {
        const label begin = runs_[k].begin, end = runs_[k].end;
        const tensor& R = runs_[k].reflection;
        const scalar Rxx = R(0, 0), Rxy = R(0, 1), Ryx = R(1, 0), Ryy = R(1, 1);
        #pragma omp simd
        for (label image = begin; image < end; ++image)
        {
            const label i = sources_[image];
            x[ghosts + image] = Rxx*x[i] + Rxy*y[i] + shifts_.x[image];
            y[ghosts + image] = Ryx*x[i] + Ryy*y[i] + shifts_.y[image];
        }
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
    addRun(label(before), patchI);
    particles_.resizeGhosts(label(images_.size()));
    place(runs_.size() - 1);
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
    sources_.clear();
    shifts_.x.clear();
    shifts_.y.clear();
    runs_.clear();
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

// One field over a run
static void refreshRun
(
    const FieldInfo& info, const label n, const label* source,
    const label ghosts, const tensor& R
)
{
    const scalar Rxx = R(0, 0), Rxy = R(0, 1), Ryx = R(1, 0), Ryy = R(1, 1);
    const auto column = [&](const int c) { return info.components[c]->data(); };
    if (info.kind == FieldKind::scalar)
    {
        scalar* a = column(0);
        #pragma omp simd
        for (label k = 0; k < n; ++k)
        {
            a[ghosts + k] = a[source[k]];
        }
    }
    else if (info.kind == FieldKind::vector)
    {
        scalar* x = column(0);
        scalar* y = column(1);
        #pragma omp simd
        for (label k = 0; k < n; ++k)
        {
            const label i = source[k];
            x[ghosts + k] = Rxx*x[i] + Rxy*y[i];
            y[ghosts + k] = Ryx*x[i] + Ryy*y[i];
        }
    }
    else    // R T R^T
    {
        const bool symmetric = info.kind == FieldKind::symmTensor;
        scalar* xx = column(0);
        scalar* xy = column(1);
        scalar* yx = column(symmetric ? 1 : 2);
        scalar* yy = column(symmetric ? 2 : 3);
        #pragma omp simd
        for (label k = 0; k < n; ++k)
        {
            const label i = source[k], to = ghosts + k;
            const scalar Axx = Rxx*xx[i] + Rxy*yx[i];
            const scalar Axy = Rxx*xy[i] + Rxy*yy[i];
            const scalar Ayx = Ryx*xx[i] + Ryy*yx[i];
            const scalar Ayy = Ryx*xy[i] + Ryy*yy[i];
            xx[to] = Axx*Rxx + Axy*Rxy;
            xy[to] = Axx*Ryx + Axy*Ryy;
            yx[to] = Ayx*Rxx + Ayy*Rxy;
            yy[to] = Ayx*Ryx + Ayy*Ryy;
        }
    }
}

// One field: images of images come after their sources
void Images::refresh(const FieldInfo& info)
{
    const label ghosts = particles_.ghosts().begin;
    for (const Run& run : runs_)
    {
        refreshRun
        (
            info, run.end - run.begin, sources_.data() + run.begin,
            ghosts + run.begin, run.reflection
        );
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
