// Reading granular.vtp and walls.vtp.
#include "io/caseIO.H"

#include "io/vtkFields.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vtkFieldData.h>

namespace sph
{

namespace
{

std::optional<scalar> spacingOf(const VtkFile& file)
{
    vtkDataArray* array = file.data->GetFieldData()->GetArray("spacing");
    if (!array || array->GetNumberOfValues() != 1)
    {
        return std::nullopt;
    }
    const scalar spacing = array->GetComponent(0, 0);
    if (!(spacing > 0) || !std::isfinite(spacing))
    {
        file.fail("The field data spacing must be greater than 0");
    }
    return spacing;
}

// Whole numbers from 0 to most
template<class Numbers>
void readWhole
(
    const VtkFile& file, const std::string& name, const scalar most,
    Numbers& numbers, const label begin
)
{
    vtkDataArray& array = file.array(name);
    for (label i = 0; i < file.size(); ++i)
    {
        const scalar value = array.GetComponent(i, 0);
        if (!(value >= 0 && value <= most && value == std::floor(value)))
        {
            file.fail
            (
                "The point array " + name + " must hold whole numbers, but is "
              + std::to_string(value) + " at point " + std::to_string(i)
            );
        }
        numbers[begin + i] = typename Numbers::value_type(value);
    }
}

void readIds(const VtkFile& file, Particles& particles, const label begin)
{
    if (file.found("id"))
    {
        // Beyond that numbers of double precision are not whole
        readWhole(file, "id", std::ldexp(1, 53), particles.id, begin);
        return;
    }
    for (label i = 0; i < file.size(); ++i)
    {
        particles.id[begin + i] = i;
    }
}

void checkPositive
(
    const VtkFile& file, const std::string& name,
    const scalarField& values, const label begin
)
{
    for (label i = 0; i < file.size(); ++i)
    {
        if (!(values[begin + i] > 0) || !std::isfinite(values[begin + i]))
        {
            file.fail
            (
                "The point array " + name
              + " must be finite and greater than 0, but is "
              + std::to_string(values[begin + i]) + " at " + file.particle(i)
            );
        }
    }
}

// m = rho V or rho dx^2 where another tool gave no mass
void deduceMass
(
    const VtkFile& file, Particles& particles, const label begin,
    const std::optional<scalar>& spacing
)
{
    if (!file.found("V") && !spacing)
    {
        file.fail
        (
            "The point array m (mass per unit depth) is missing, and neither"
            " the point array V (volume per unit depth) nor the field data"
            " spacing is there to deduce it from rho"
        );
    }
    for (label i = begin; i < begin + file.size(); ++i)
    {
        const scalar V =
            file.found("V") ? particles.V[i] : *spacing**spacing;
        particles.m[i] = particles.rho[i]*V;
    }
}

// Every field that is in the file. Returns whether all state fields were.
bool readFields
(
    const VtkFile& file, Particles& particles, const label begin,
    const std::optional<scalar>& spacing
)
{
    bool complete = true;
    file.readPoints(particles.r, begin);
    for (const FieldInfo& info : particles.fields())
    {
        if (file.found(info.name) || (info.mandatory && info.name != "m"))
        {
            file.read(info.name, info.kind, info.components, begin);
        }
        else if (info.state && info.used)
        {
            complete = false;
        }
    }
    readIds(file, particles, begin);

    checkPositive(file, "rho", particles.rho, begin);
    if (!file.found("m"))
    {
        deduceMass(file, particles, begin, spacing);
    }
    checkPositive(file, "m", particles.m, begin);
    if (!file.found("V"))
    {
        for (label i = begin; i < begin + file.size(); ++i)
        {
            particles.V[i] = particles.m[i]/particles.rho[i];
        }
        checkPositive(file, "V = m/rho", particles.V, begin);
    }
    return complete;
}

void readWalls
(
    const VtkFile& file, Particles& particles, const label begin,
    const std::optional<scalar>& spacing
)
{
    readFields(file, particles, begin, spacing);
    file.read("n", FieldKind::vector, {&particles.n.x, &particles.n.y}, begin);
    readWhole
    (
        file, "patch", std::numeric_limits<label>::max(), particles.patch,
        begin
    );
}

} // namespace


static const char* const advice =
    "\n\nRemove this time folder to start from the one before it, or run"
    " setParticles:\nit makes the particles of the start time";

bool readState(const std::filesystem::path& folder, Particles& particles)
{
    const VtkFile granular(folder/"granular.vtp", advice);
    if (granular.size() == 0)
    {
        granular.fail("There are no particles in the file");
    }
    std::optional<VtkFile> walls;
    if (std::filesystem::exists(folder/"walls.vtp"))
    {
        walls.emplace(folder/"walls.vtp", advice);
    }

    // Null particles first, so that what is in no file is 0
    particles.resize(0, 0);
    particles.resize(granular.size(), walls ? walls->size() : 0);

    const std::optional<scalar> spacing = spacingOf(granular);
    const bool complete = readFields
    (
        granular, particles, particles.granular().begin, spacing
    );
    if (walls)
    {
        readWalls(*walls, particles, particles.walls().begin, spacing);
    }

    scalar largest = 0;
    for (label i = 0; i < granular.size(); ++i)
    {
        largest = std::max(largest, particles.m[i]/particles.rho[i]);
    }
    particles.setSpacing(spacing.value_or(std::sqrt(largest)));
    return complete;
}

} // namespace sph
