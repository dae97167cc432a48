// The data that the script of a picture draws
#include "functionObjects/ParticlePicture.H"

#include "functionObjects/PictureLayout.H"
#include "primitives/writeFile.H"

#include <ostream>

namespace sph
{

void ParticlePicture::writeData
(
    const std::filesystem::path& folder, const word& name,
    const PictureLayout& layout
) const
{
    const scalar u = layout.unit;
    for (std::size_t k = 0; k < panels_.size(); ++k)
    {
        const auto write = [&](std::ostream& os, const std::vector<Dot>& dots)
        {
            os << "# x y radius [" << layout.unitName << "] value\n";
            for (const Dot& dot : dots)
            {
                os  << u*dot.r.x() << ' ' << u*dot.r.y() << ' '
                    << u*dot.radius << ' ' << dot.value << '\n';
            }
        };
        // Blocks of data, for gnuplot's index: granular, walls, arrows and the
        // sliding interface
        writeFile
        (
            folder/(name + "_" + std::to_string(k) + ".dat"),
            [&](std::ostream& os)
            {
                write(os, panels_[k].granular);
                os << "\n\n";
                write(os, panels_[k].walls);
                os << "\n\n# x y dx dy [" << layout.unitName << "]\n";
                for (const VelocityArrow& arrow : panels_[k].arrows)
                {
                    const vector d = metresPerSpeed()*arrow.U;
                    os  << u*arrow.r.x() << ' ' << u*arrow.r.y() << ' '
                        << u*d.x() << ' ' << u*d.y() << '\n';
                }
                os << "\n\n# x y [" << layout.unitName << "]\n";
                for (const vector& r : panels_[k].interface)
                {
                    os << u*r.x() << ' ' << u*r.y() << '\n';
                }
            }
        );
    }
}

} // namespace sph
