// PolyData of VTK's legacy format: a surface, or lines.
//
//     geometry { file "constant/geometry/bed.vtk"; }

#include "geometry/SurfaceFormat.H"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>

namespace sph
{
namespace
{

class vtk : public SurfaceFormat
{
    vtkSmartPointer<vtkPolyData> read() const override
    {
        vtkNew<vtkPolyDataReader> reader;
        reader->SetFileName(path().c_str());
        return outputOf(*reader);
    }

public:
    using SurfaceFormat::SurfaceFormat;
};

static const GeometryFormat::Add<vtk> add
(
    "vtk", "legacy VTK PolyData: a surface cut at a plane, or lines"
);

} // namespace
} // namespace sph
