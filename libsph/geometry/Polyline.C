#include "geometry/Polyline.H"

#include "geometry/GeometryFormat.H"
#include "geometry/simplified.H"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

namespace sph
{

std::string asText(const vector& point)
{
    std::ostringstream os;
    os << '(' << point.x() << ' ' << point.y() << " 0)";
    return os.str();
}

namespace
{

bool isClosed(const FileLine& line)
{
    return line.points.size() > 3 && line.points.front() == line.points.back();
}

// The one that the entry line names; there may be no need to name it
FileLine chosen
(
    const dictionary& dict, const std::vector<FileLine>& lines,
    const label number, const std::string& file
)
{
    const label count = label(lines.size());
    if (number >= 1 && number <= count && (count == 1 || dict.found("line")))
    {
        return lines[number - 1];
    }
    std::ostringstream os;
    os
        << (dict.found("line") ? "There is no such line in " : "Which line of ")
        << file << (dict.found("line") ? "" : "? Choose one by line <number>;")
        << "\n\nLines in the file (in its coordinates) :\n";
    for (label k = 0; k < count; ++k)
    {
        os
            << "\n    " << k + 1 << "  " << lines[k].points.size()
            << " points, " << (isClosed(lines[k]) ? "closed, " : "open, ")
            << "from " << asText(lines[k].points.front()) << " to "
            << asText(lines[k].points.back());
    }
    dict.fail(dict.found("line") ? "line" : "file", os.str());
}

// What is done with the line of a file
struct Placement
{
    const label number;
    const scalar scale;
    const scalar angle;     // [rad]
    const vector shift;     // [m]
    const bool flip;
    const scalar shortest;  // [m]

    Placement(const dictionary& dict, const scalar shortest)
    :
        number
        (
            dict.getOrDefault<label>
            (
                {"line", "which line of the file, where there are several"}, 1
            )
        ),
        scale
        (
            dict.getOrDefault
            (
                {"scale", "metres in a unit of the file"}, 1,
                dimless, Range::positive()
            )
        ),
        angle
        (
            pi/180*dict.getOrDefault<scalar>
            (
                {"rotate", "anticlockwise about the origin, degrees"}, 0
            )
        ),
        shift
        (
            dict.getVectorOrDefault
            (
                {"translate", "shift after all else"}, vector::Zero(),
                dimLength
            )
        ),
        flip(dict.getOrDefault<bool>({"flip", "the other way round"}, false)),
        shortest
        (
            dict.getOrDefault
            (
                {
                    "shortest", "shorter sides are left out; of a wall dx,"
                    " of a region 0 m if nothing is said", "0.002"
                },
                shortest, dimLength, Range::nonNegative()
            )
        )
    {}

    void apply(std::vector<vector>& points) const
    {
        tensor R = tensor::Identity();
        if (angle != 0)
        {
            R << std::cos(angle), -std::sin(angle),
                std::sin(angle), std::cos(angle);
        }
        for (vector& point : points)
        {
            point = R*(scale*point) + shift;
        }
    }
};

} // namespace


Polyline::Polyline(const dictionary& dict, const scalar shortest)
:
    dict_(&dict)
{
    const Key points
    {
        "points", "polyline [m] in order; a wall has the material on its left",
        "((0 0 0) (0.4 0 0) (0.2 0.2 0))"
    };
    const Key geometry
    {
        "geometry", "in place of points: a line of a file",
        "{ file \"constant/bed.csv\"; }"
    };
    const bool fromFile = dict.found(geometry);
    if (fromFile ? dict.found(points) : !dict.found(points) && !dict.fillsIn())
    {
        dict.fail
        (
            fromFile ? "geometry" : "",
            "Either points ( ... ); or geometry { file ...; } must be given"
        );
    }
    if (fromFile)
    {
        readFile(dict.subDict(geometry), shortest);
    }
    else
    {
        points_ = dict.get<std::vector<vector>>(points);
    }
}

void Polyline::readFile(const dictionary& dict, const scalar shortest)
{
    const auto format = GeometryFormat::ofFile(dict);
    const Placement placement(dict, shortest);
    file_ = format->path().string();
    FileLine line = chosen(dict, format->lines(), placement.number, file_);
    points_ = std::move(line.points);
    places_ = std::move(line.places);
    mayBeJoined_ = line.mayBeJoined;
    placement.apply(points_);
    if (placement.flip)
    {
        std::reverse(points_.begin(), points_.end());
        std::reverse(places_.begin(), places_.end());
    }
    simplify(placement.shortest);
}

void Polyline::simplify(const scalar shortest)
{
    const std::vector<label> left = simplified(points_, shortest);
    const scalar off = greatestDeparture(points_, left);
    const std::size_t before = points_.size();
    for (std::size_t k = 0; k < left.size(); ++k)
    {
        points_[k] = points_[left[k]];
        if (!places_.empty())
        {
            places_[k] = places_[left[k]];
        }
    }
    points_.resize(left.size());
    places_.resize(std::min(places_.size(), left.size()));
    report(before, off);
}

void Polyline::report(const std::size_t before, const scalar off) const
{
    std::cout
        << "Reading " << std::filesystem::path(file_).filename().string()
        << ": " << points_.size() << " points from " << asText(points_.front())
        << " to " << asText(points_.back()) << '\n';
    if (before > points_.size())
    {
        std::cout
            << "    without " << before - points_.size()
            << " more, on straight parts or at the ends of shorter sides, up"
               " to " << off << " m from it\n";
    }
}

void Polyline::fail(const std::string& message, const label point) const
{
    if (!fromFile())
    {
        dict_->fail("points", message);
    }
    const bool placed = point >= 0 && !places_.empty();
    throw IOError
    (
        message + "\n\nThis line is read for \"" + dict_->name() + '"', file_,
        placed ? places_[point] : 0
    );
}

} // namespace sph
