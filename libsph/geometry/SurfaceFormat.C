#include "geometry/SurfaceFormat.H"

#include "geometry/cutLines.H"
#include "io/VtkMessages.H"

#include <sstream>
#include <vtkAlgorithm.h>
#include <vtkPolyData.h>

namespace sph
{

SurfaceFormat::SurfaceFormat
(
    const dictionary& dict, const std::filesystem::path& path
)
:
    GeometryFormat(path),
    plane_(dict.subOrEmptyDict({"plane", "what cuts the surface"}))
{}

vtkSmartPointer<vtkPolyData> SurfaceFormat::outputOf
(
    vtkAlgorithm& reader
) const
{
    VtkMessages messages;
    std::string complaint;
    try
    {
        reader.Update();
    }
    catch (const std::exception& error)     // bad_alloc, length_error
    {
        complaint = error.what();
    }
    complaint += messages.text();
    if (!complaint.empty() || reader.GetErrorCode() != 0)
    {
        throw IOError
        (
            "The file is broken, or not of this format:\n\n" + complaint,
            path().string()
        );
    }
    return vtkPolyData::SafeDownCast(reader.GetOutputDataObject(0));
}

// How far the surface reaches on either side of the plane
void SurfaceFormat::failToCut(vtkPolyData& surface) const
{
    scalar least = 0, most = 0;
    for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i)
    {
        Eigen::Vector3d r;
        surface.GetPoint(i, r.data());
        const scalar height = (r - plane_.origin).dot(plane_.normal);
        least = i == 0 ? height : std::min(least, height);
        most = i == 0 ? height : std::max(most, height);
    }
    std::ostringstream text;
    text
        << "The plane does not cut the surface, which lies from " << least
        << " to " << most << " along its normal\n\n"
           "Another origin of the plane may be meant";
    throw IOError(text.str(), path().string());
}

std::vector<FileLine> SurfaceFormat::lines() const
{
    const auto data = read();
    const bool isSurface =
        data->GetNumberOfPolys() > 0 || data->GetNumberOfStrips() > 0;
    if (!isSurface && data->GetNumberOfLines() == 0)
    {
        throw IOError
        (
            "The file holds neither a surface nor lines", path().string()
        );
    }
    if (!isSurface)
    {
        return drawnLines(*data, plane_);
    }
    auto lines = cutLines(*data, plane_, path().string());
    if (lines.empty())
    {
        failToCut(*data);
    }
    return lines;
}

} // namespace sph
