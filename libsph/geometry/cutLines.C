#include "geometry/cutLines.H"

#include "runTime/log.H"

#include <algorithm>
#include <map>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkCutter.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkStripper.h>

namespace sph
{

namespace
{

using Ids = std::vector<vtkIdType>;

vector pointIn(vtkPolyData& data, const CutPlane& plane, const vtkIdType id)
{
    Eigen::Vector3d r;
    data.GetPoint(id, r.data());
    return plane.components(r - plane.origin);
}

std::vector<Ids> linesOf(vtkPolyData& data)
{
    std::vector<Ids> lines;
    vtkCellArray& cells = *data.GetLines();
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    for (cells.InitTraversal(); cells.GetNextCell(size, ids); )
    {
        lines.emplace_back(ids, ids + size);
    }
    return lines;
}

// Points nearer to each other than 1e-6 of the extent become one
vtkSmartPointer<vtkPolyData> merged(vtkPolyData& segments)
{
    vtkNew<vtkCleanPolyData> clean;
    clean->SetInputData(&segments);
    clean->SetTolerance(1e-6);
    clean->Update();
    return clean->GetOutput();
}

// Of the same points
std::vector<Ids> strips(vtkPolyData& segments)
{
    vtkNew<vtkStripper> stripper;
    stripper->SetInputData(&segments);
    stripper->JoinContiguousSegmentsOn();
    stripper->SetMaximumLength(int(segments.GetNumberOfLines()) + 2);
    stripper->Update();
    return linesOf(*stripper->GetOutput());
}

FileLine lineThrough
(
    vtkPolyData& data, const CutPlane& plane, const Ids& ids
)
{
    FileLine line;
    for (const vtkIdType id : ids)
    {
        line.points.push_back(pointIn(data, plane, id));
    }
    line.mayBeJoined = false;
    return line;
}

scalar length(const FileLine& line)
{
    scalar sum = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
    {
        sum += (line.points[i] - line.points[i - 1]).norm();
    }
    return sum;
}

void sort(std::vector<FileLine>& lines)
{
    std::stable_sort
    (
        lines.begin(), lines.end(),
        [](const FileLine& a, const FileLine& b)
        {
            return length(a) > length(b);
        }
    );
}

bool leftOf(const vector& a, const vector& b)
{
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

bool isClosed(const FileLine& line)
{
    return line.points.size() > 3 && line.points.front() == line.points.back();
}

void beginAtTheLeft(FileLine& line)
{
    line.points.pop_back();
    std::rotate
    (
        line.points.begin(),
        std::min_element(line.points.begin(), line.points.end(), leftOf),
        line.points.end()
    );
    line.points.push_back(line.points.front());
}

// The normals of the triangles that were cut, by the ends of their segments
class Sides
{
    std::map<std::pair<vtkIdType, vtkIdType>, vector> normals_;

public:
    Sides(vtkPolyData& segments, const CutPlane& plane)
    {
        vtkDataArray& normals = *segments.GetCellData()->GetArray("Normals");
        vtkIdType cell = segments.GetNumberOfVerts();
        for (const Ids& ids : linesOf(segments))
        {
            Eigen::Vector3d n;
            normals.GetTuple(cell++, n.data());
            for (std::size_t i = 1; i < ids.size(); ++i)
            {
                normals_[{ids[i - 1], ids[i]}] = plane.components(n);
            }
        }
    }

    // From -1, all normals point to the right of the line, to 1, to its left
    scalar left(const Ids& ids, const FileLine& line) const
    {
        scalar sum = 0, all = 0;
        for (std::size_t i = 1; i < ids.size(); ++i)
        {
            auto found = normals_.find({ids[i - 1], ids[i]});
            if (found == normals_.end())
            {
                found = normals_.find({ids[i], ids[i - 1]});
            }
            if (found != normals_.end())
            {
                const vector d = line.points[i] - line.points[i - 1];
                const vector& n = found->second;
                sum += d.x()*n.y() - d.y()*n.x();
                all += d.norm()*n.norm();
            }
        }
        return all > 0 ? sum/all : 0;
    }
};

} // namespace


std::vector<FileLine> drawnLines(vtkPolyData& lines, const CutPlane& plane)
{
    const auto segments = merged(lines);
    std::vector<FileLine> all;
    for (const Ids& ids : strips(*segments))
    {
        all.push_back(lineThrough(*segments, plane, ids));
    }
    sort(all);
    return all;
}

std::vector<FileLine> cutLines
(
    vtkPolyData& surface, const CutPlane& plane, const std::string& name
)
{
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(&surface);
    normals->ComputePointNormalsOff();
    normals->ComputeCellNormalsOn();
    normals->SplittingOff();
    normals->ConsistencyOff();

    vtkNew<vtkPlane> cut;
    cut->SetOrigin(plane.origin.x(), plane.origin.y(), plane.origin.z());
    cut->SetNormal(plane.normal.x(), plane.normal.y(), plane.normal.z());
    vtkNew<vtkCutter> cutter;
    cutter->SetInputConnection(normals->GetOutputPort());
    cutter->SetCutFunction(cut);
    cutter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    cutter->Update();
    if (cutter->GetOutput()->GetNumberOfLines() == 0)
    {
        return {};
    }

    const auto segments = merged(*cutter->GetOutput());
    const Sides sides(*segments, plane);
    std::vector<FileLine> all;
    for (const Ids& ids : strips(*segments))
    {
        FileLine line = lineThrough(*segments, plane, ids);
        const scalar left = sides.left(ids, line);
        if (std::abs(left) < 0.9)
        {
            warning
            (
                "The normals of " + name + " disagree about the side of the"
                " material: most of them decide"
            );
        }
        if (left < 0)
        {
            std::reverse(line.points.begin(), line.points.end());
        }
        if (isClosed(line))
        {
            beginAtTheLeft(line);
        }
        all.push_back(line);
    }
    sort(all);
    return all;
}

} // namespace sph
