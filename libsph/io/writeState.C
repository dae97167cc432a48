// Writing granular.vtp and walls.vtp.
#include "io/caseIO.H"

#include "io/VtkMessages.H"
#include "io/vtkFields.H"
#include "primitives/writeFile.H"

#include <ostream>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

namespace sph
{

namespace
{

vtkSmartPointer<vtkDataArray> number(const char* name, const scalar value)
{
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->InsertNextValue(value);
    return array;
}

// Points with one vertex each, their ids, and the field data
vtkSmartPointer<vtkPolyData> polyData
(
    const Particles& particles, const ParticleRange range,
    const scalar time, const label digits
)
{
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData
    (
        toVtk
        (
            "Points", FieldKind::vector, {&particles.r.x, &particles.r.y},
            range, digits
        )
    );

    auto vertices = vtkSmartPointer<vtkCellArray>::New();
    auto ids = vtkSmartPointer<vtkTypeInt64Array>::New();
    ids->SetName("id");
    ids->SetNumberOfTuples(range.size());
    for (vtkIdType i = 0; i < range.size(); ++i)
    {
        vertices->InsertNextCell(1, &i);
        ids->SetValue(i, particles.id[range.begin + i]);
    }

    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetVerts(vertices);
    data->GetPointData()->AddArray(ids);
    data->GetFieldData()->AddArray(number("TimeValue", time));
    data->GetFieldData()->AddArray(number("spacing", particles.spacing()));
    return data;
}

void addField
(
    vtkPolyData& data, const FieldInfo& info,
    const ParticleRange range, const label digits
)
{
    data.GetPointData()->AddArray
    (
        toVtk
        (
            info.name, info.kind,
            {info.components.begin(), info.components.end()}, range, digits
        )
    );
}

// sigma = s - p 1, of which zz = -p as s has no zz here
void addStress
(
    vtkPolyData& data, const Particles& particles,
    const ParticleRange range, const label digits
)
{
    const symmTensorField& s = particles.s;
    scalarField xx(s.xx), yy(s.yy), zz(s.xx.size(), 0);
    for (label i = range.begin; i < range.end; ++i)
    {
        xx[i] -= particles.p[i];
        yy[i] -= particles.p[i];
        zz[i] -= particles.p[i];
    }
    auto sigma = toVtk
    (
        "sigma", FieldKind::symmTensor, {&xx, &s.xy, &yy}, range, digits
    );
    auto planeNormal = toVtk("zz", FieldKind::scalar, {&zz}, range, digits);
    sigma->CopyComponent(2, planeNormal, 0);
    data.GetPointData()->AddArray(sigma);
}

void writePolyData
(
    vtkPolyData& data, const std::filesystem::path& path,
    const WriteOptions& options
)
{
    VtkMessages messages;
    auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
    writer->SetInputData(&data);
    writer->SetHeaderTypeToUInt64();
    if (options.compress)
    {
        writer->SetCompressorTypeToZLib();
    }
    else
    {
        writer->SetCompressorTypeToNone();
    }
    if (options.ascii)
    {
        writer->SetDataModeToAscii();
    }
    else
    {
        writer->SetDataModeToAppended();
        writer->EncodeAppendedDataOff();
    }
    writer->WriteToOutputStringOn();
    if (writer->Write() != 1 || !messages.text().empty())
    {
        throw Error("Cannot write " + path.string() + ": " + messages.text());
    }
    writeFile
    (
        path, [&](std::ostream& os) { os << writer->GetOutputString(); }
    );
}

void writeGranular
(
    const Particles& particles, const scalar time,
    const std::filesystem::path& path,
    const WriteOptions& options, const label digits
)
{
    const ParticleRange range = particles.granular();
    auto data = polyData(particles, range, time, digits);
    for (const FieldInfo& info : particles.fields())
    {
        const bool shown =
            info.name == "V" || info.name == "p" || info.name == "lambda"
         || info.name == "div" || info.name == "gammaDot" || info.name == "I"
         || info.name == "illPosed";
        if ((info.state || shown) && info.used)
        {
            addField(*data, info, range, digits);
        }
    }
    addStress(*data, particles, range, digits);
    writePolyData(*data, path, options);
}

void writeWalls
(
    const Particles& particles, const scalar time,
    const std::filesystem::path& path,
    const WriteOptions& options, const label digits
)
{
    const ParticleRange range = particles.walls();
    auto data = polyData(particles, range, time, digits);

    auto patch = vtkSmartPointer<vtkIntArray>::New();
    patch->SetName("patch");
    patch->SetNumberOfTuples(range.size());
    for (label i = 0; i < range.size(); ++i)
    {
        patch->SetValue(i, particles.patch[range.begin + i]);
    }
    data->GetPointData()->AddArray(patch);
    data->GetPointData()->AddArray
    (
        toVtk
        (
            "n", FieldKind::vector, {&particles.n.x, &particles.n.y},
            range, digits
        )
    );
    for (const char* name : {"U", "p", "rho", "m", "s", "tauWall"})
    {
        const FieldInfo& info = particles.field(name);
        if (info.used)
        {
            addField(*data, info, range, digits);
        }
    }
    addStress(*data, particles, range, digits);
    writePolyData(*data, path, options);
}

} // namespace


void writeState
(
    const Particles& particles,
    const scalar time,
    const std::filesystem::path& folder,
    const WriteOptions& options
)
{
    const label digits = options.ascii ? options.precision : 17;
    const std::filesystem::path walls = folder/"walls.vtp";
    if (particles.walls().size() > 0)
    {
        writeWalls(particles, time, walls, options, digits);
    }
    else
    {
        std::error_code ignored;
        std::filesystem::remove(walls, ignored);
    }

    // Last: a folder with granular.vtp is complete
    writeGranular(particles, time, folder/"granular.vtp", options, digits);
}

} // namespace sph
