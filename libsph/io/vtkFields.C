#include "io/vtkFields.H"

#include "io/VtkMessages.H"
#include "io/VtkReader.H"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>

namespace sph
{

namespace
{

scalar rounded(const scalar value, const label digits)
{
    if (digits >= 17)
    {
        return value;
    }
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", int(digits), value);
    return std::strtod(text.data(), nullptr);
}

} // namespace


const VtkLayout& vtkLayout(const FieldKind kind)
{
    static const VtkLayout scalars{1, {0}, {}};
    static const VtkLayout vectors{3, {0, 1}, {"X", "Y", "Z"}};
    static const VtkLayout symmTensors
    {
        6, {0, 3, 1}, {"XX", "YY", "ZZ", "XY", "YZ", "XZ"}
    };
    static const VtkLayout tensors
    {
        9, {0, 1, 3, 4},
        {"XX", "XY", "XZ", "YX", "YY", "YZ", "ZX", "ZY", "ZZ"}
    };
    return
        kind == FieldKind::scalar ? scalars
      : kind == FieldKind::vector ? vectors
      : kind == FieldKind::symmTensor ? symmTensors : tensors;
}

vtkSmartPointer<vtkDataArray> toVtk
(
    const std::string& name, const FieldKind kind,
    const std::vector<const scalarField*>& components,
    const ParticleRange range, const label digits
)
{
    const VtkLayout& layout = vtkLayout(kind);
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(layout.size);
    for (std::size_t c = 0; c < layout.names.size(); ++c)
    {
        array->SetComponentName(c, layout.names[c]);
    }
    array->SetNumberOfTuples(range.size());
    array->Fill(0);
    for (std::size_t c = 0; c < components.size(); ++c)
    {
        const scalarField& values = *components[c];
        for (label i = 0; i < range.size(); ++i)
        {
            array->SetTypedComponent
            (
                i, layout.position[c], rounded(values[range.begin + i], digits)
            );
        }
    }
    return array;
}


VtkFile::VtkFile
(
    const std::filesystem::path& file, const std::string& advice
)
:
    path(file)
{
    if (!std::filesystem::is_regular_file(path))
    {
        throw IOError("There is no such file" + advice, path.string());
    }

    VtkMessages messages;
    auto reader = vtkSmartPointer<VtkReader>::New();
    try
    {
        reader->SetFileName(path.c_str());
        reader->Update();
    }
    catch (const std::exception&)   // bad_alloc, length_error
    {
        fail("The file is broken: its sizes do not fit into memory" + advice);
    }
    data = reader->GetOutput();
    if (!messages.text().empty() || reader->GetErrorCode() != 0)
    {
        fail
        (
            "The file is broken, or no VTK XML PolyData (.vtp):\n\n"
          + messages.text() + advice
        );
    }
}

void VtkFile::fail(const std::string& message) const
{
    throw IOError(message, path.string());
}

bool VtkFile::found(const std::string& name) const
{
    return data->GetPointData()->HasArray(name.c_str()) != 0;
}

vtkDataArray& VtkFile::array(const std::string& name) const
{
    vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
    if (!array)
    {
        wordList names;
        for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
        {
            const char* present = data->GetPointData()->GetArrayName(i);
            names.push_back(present ? present : "");
        }
        fail
        (
            "The point array " + name + " is missing\n\nArrays there :\n\n"
          + listOfWords(names)
        );
    }
    if (array->GetNumberOfTuples() != data->GetNumberOfPoints())
    {
        fail
        (
            "The point array " + name + " has "
          + std::to_string(array->GetNumberOfTuples()) + " values for "
          + std::to_string(size()) + " particles"
        );
    }
    return *array;
}

std::string VtkFile::particle(const label i) const
{
    const std::int64_t id =
        found("id") ? std::int64_t(array("id").GetComponent(i, 0)) : i;
    return "particle " + std::to_string(id);
}

void VtkFile::read
(
    const std::string& name, const FieldKind kind,
    const std::vector<scalarField*>& components, const label begin
) const
{
    vtkDataArray& values = array(name);
    const VtkLayout& layout = vtkLayout(kind);
    const int given = values.GetNumberOfComponents();
    const bool plane = kind == FieldKind::vector && given == 2;
    if (given != layout.size && !plane)
    {
        fail
        (
            "The point array " + name + " has " + std::to_string(given)
          + " components; it must have " + std::to_string(layout.size)
          + (kind == FieldKind::vector ? " or 2" : "")
        );
    }
    for (std::size_t c = 0; c < components.size(); ++c)
    {
        for (label i = 0; i < size(); ++i)
        {
            const scalar value = values.GetComponent(i, layout.position[c]);
            if (!std::isfinite(value))
            {
                fail
                (
                    "The point array " + name + " is not finite at "
                  + particle(i)
                );
            }
            (*components[c])[begin + i] = value;
        }
    }
}

void VtkFile::readPoints(vectorField& r, const label begin) const
{
    for (label i = 0; i < size(); ++i)
    {
        std::array<scalar, 3> x{};
        data->GetPoint(i, x.data());
        if (!std::isfinite(x[0]) || !std::isfinite(x[1]))
        {
            fail("The position of " + particle(i) + " is not finite");
        }
        if (x[2] != 0)
        {
            fail
            (
                "The position of " + particle(i) + " is out of the plane z = 0"
            );
        }
        r.set(begin + i, {x[0], x[1]});
    }
}

} // namespace sph
