// Triangles of stereolithography, ASCII or binary; in single precision.
//
//     geometry { file "constant/geometry/bed.stl"; }

#include "geometry/SurfaceFormat.H"

#include <array>
#include <cstring>
#include <fstream>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

namespace sph
{
namespace
{

class stl : public SurfaceFormat
{
    // VTK takes a binary file that was cut off for a whole one
    void checkLength() const
    {
        std::array<char, 84> head{};
        std::ifstream is(path(), std::ios::binary);
        is.read(head.data(), head.size());
        if (!is || std::string(head.data(), 5) == "solid")
        {
            return;
        }
        std::uint32_t count = 0;
        std::memcpy(&count, head.data() + 80, sizeof count);
        if (std::filesystem::file_size(path()) < 84 + 50*std::uintmax_t(count))
        {
            throw IOError
            (
                "The file is broken: it is too short for the "
              + std::to_string(count) + " triangles that it announces",
                path().string()
            );
        }
    }

    vtkSmartPointer<vtkPolyData> read() const override
    {
        checkLength();
        vtkNew<vtkSTLReader> reader;
        reader->SetFileName(path().c_str());
        return outputOf(*reader);
    }

public:
    using SurfaceFormat::SurfaceFormat;
};

static const GeometryFormat::Add<stl> add
(
    "stl", "triangles, ASCII or binary, cut at a plane"
);

} // namespace
} // namespace sph
