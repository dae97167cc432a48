// PolyData of VTK's XML format: a surface, or lines.
//
//     geometry { file "constant/geometry/bed.vtp"; }

#include "geometry/SurfaceFormat.H"
#include "io/VtkReader.H"

#include <vtkNew.h>
#include <vtkPolyData.h>

namespace sph
{
namespace
{

class vtp : public SurfaceFormat
{
    vtkSmartPointer<vtkPolyData> read() const override
    {
        vtkNew<VtkReader> reader;
        reader->readCells();
        reader->SetFileName(path().c_str());
        return outputOf(*reader);
    }

public:
    using SurfaceFormat::SurfaceFormat;
};

static const GeometryFormat::Add<vtp> add
(
    "vtp", "VTK XML PolyData: a surface cut at a plane, or lines"
);

} // namespace
} // namespace sph
