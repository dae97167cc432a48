#include "functionObjects/ParticlePicture.H"

#include "deposit/magnitude.H"
#include "deposit/slidingInterface.H"
#include "functionObjects/PictureLayout.H"
#include "functionObjects/gnuplot.H"
#include "primitives/writeFile.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace sph
{

ParticlePicture::ParticlePicture(const Options& options)
:
    options_(options),
    low_(vector::Constant(std::numeric_limits<scalar>::max())),
    high_(-low_)
{}


void ParticlePicture::addPanel
(
    const Particles& particles, const std::string& title
)
{
    const FieldInfo& field = particles.field(options_.field);
    const std::string& text = field.description;
    const auto bracket = text.find('[');
    valueLabel_ =
        gnuplotText(magnitudeName(field))
      + (
            bracket == std::string::npos ? ""
          : "  " + gnuplotText(text.substr(bracket))
        );

    Panel panel;
    panel.title = title;
    if (options_.vectors)
    {
        panel.arrows =
            velocityArrows(particles, arrowSpacing*particles.spacing());
    }
    if (options_.slidingSpeed)
    {
        panel.interface = slidingInterface(particles, *options_.slidingSpeed);
    }
    const scalar dx = particles.spacing();
    spacing_ = dx;
    const ParticleRange granular = particles.granular();
    for (label i = granular.begin; i < granular.end; ++i)
    {
        const vector r = particles.r[i];
        const scalar radius =
            0.66*std::sqrt(particles.m[i]/particles.rho[i]);
        panel.granular.push_back({r, radius, magnitude(field, i)});
        low_ = low_.cwiseMin(r - vector(2, 4)*dx);
        high_ = high_.cwiseMax(r + vector(2, 2)*dx);
    }
    const ParticleRange walls = particles.walls();
    for (label i = walls.begin; i < walls.end; ++i)
    {
        panel.walls.push_back({particles.r[i], 0.72*dx, 0});
    }
    panels_.push_back(std::move(panel));
}


// The fastest arrow of all panels is as long as a square
scalar ParticlePicture::metresPerSpeed() const
{
    scalar fastest = 1e-12;
    for (const Panel& panel : panels_)
    {
        for (const VelocityArrow& arrow : panel.arrows)
        {
            fastest = std::max(fastest, arrow.U.norm());
        }
    }
    return arrowSpacing*spacing_/fastest;
}


void ParticlePicture::addMark(const Mark& mark)
{
    marks_.push_back(mark);
    for (const vector& point : mark.points)
    {
        low_ = low_.cwiseMin(point);
        high_ = high_.cwiseMax(point);
    }
}


// From 0 for what has no negative values; the highest 0.5 % are cut off
std::pair<scalar, scalar> ParticlePicture::colourRange() const
{
    if (options_.range)
    {
        return *options_.range;
    }
    std::vector<scalar> values;
    for (const Panel& panel : panels_)
    {
        for (const Dot& dot : panel.granular)
        {
            values.push_back(dot.value);
        }
    }
    if (values.empty())
    {
        return {0, 1};
    }
    std::sort(values.begin(), values.end());
    const scalar low = values[values.size()/200];
    const scalar high = values[values.size() - 1 - values.size()/200];
    const scalar from = low >= 0 && low < 0.5*high ? 0 : low;
    return {from, high > from ? high : from + 1};
}


void ParticlePicture::writeHead
(
    std::ostream& os, const word& name, const PictureLayout& layout
) const
{
    const auto [low, high] = colourRange();
    const scalar W = layout.imageWidth(), H = layout.imageHeight();
    os  << "set terminal pngcairo size " << std::lround(W) << ','
        << std::lround(H) << " enhanced font 'DejaVu Sans,11'\n"
        << "set output '" << name << ".png'\n"
        << "set palette defined (0 '#440154', 1 '#46327e', 2 '#365c8d',"
           " 3 '#277f8e', 4 '#1fa187', 5 '#4ac16d', 6 '#a0da39',"
           " 7 '#fde725')\n"
        << "set cbrange [" << low << ':' << high << "]\n"
        << "set cblabel '" << valueLabel_ << "' offset 1.2\n"
        << "set colorbox user origin screen "
        << (W - layout.right + 22)/W << ", screen " << layout.bottom/H
        << " size screen " << 16/W << ", screen "
        << (H - layout.bottom - layout.top)/H << "\n"
        << "set xrange [" << layout.low.x() << ':' << layout.high.x() << "]\n"
        << "set yrange [" << layout.low.y() << ':' << layout.high.y() << "]\n"
        << "set border lc rgb '#404040'\n"
        << "set tics out nomirror scale 0.6\n"
        << "set style fill solid 1 noborder\n"
        << "set multiplot\n";
}


void ParticlePicture::writePanel
(
    std::ostream& os, const word& name, const PictureLayout& layout,
    const label panel
) const
{
    const scalar W = layout.imageWidth(), H = layout.imageHeight();
    const vector corner = layout.corner(panel);
    const bool leftmost = panel % layout.columns == 0;
    const bool lowest = panel + layout.columns >= label(panels_.size());
    const std::string data =
        "'" + name + "_" + std::to_string(panel) + ".dat'";

    os  << "\nset lmargin at screen " << corner.x()/W
        << "; set rmargin at screen " << (corner.x() + layout.width)/W
        << "\nset bmargin at screen " << corner.y()/H
        << "; set tmargin at screen " << (corner.y() + layout.height)/H
        << "\nset format x '" << (lowest ? "%g" : "") << "'; set xlabel '"
        << (lowest ? "x  [" + layout.unitName + "]" : "")
        << "'\nset format y '" << (leftmost ? "%g" : "") << "'; set ylabel '"
        << (leftmost ? "y  [" + layout.unitName + "]" : "")
        << "'\nset label 1 '" << panels_[panel].title
        << "' at graph 0.985, graph 0.985 offset 0,-0.7 right front\n";
    if (panel == 0 && !marks_.empty())
    {
        os  << "set key at screen " << 0.5 << ", screen " << 18/H
            << " center bottom horizontal samplen 3 width 2\n";
    }
    else
    {
        os << "unset key\n";
    }
    os  << (panel == 0 ? "" : "unset colorbox\n")
        << "plot " << data << " index 1 using 1:2:3 with circles"
        << " lc rgb '#8c8c8c' notitle, \\\n    " << data
        << " index 0 using 1:2:3:4 with circles lc palette notitle";
    if (!panels_[panel].arrows.empty())
    {
        os  << ", \\\n    " << data << " index 2 using 1:2:3:4 with vectors"
            << " lc rgb 'black' lw 0.7 notitle";
    }
    if (!panels_[panel].interface.empty())
    {
        os  << ", \\\n    " << data << " index 3 using 1:2 with lines"
            << " lc rgb '#d62728' lw 2 notitle";
    }
    for (std::size_t k = 0; k < marks_.size(); ++k)
    {
        os  << ", \\\n    $mark" << k << " with lines lw 1.6 "
            << marks_[k].style << " title '" << gnuplotText(marks_[k].title)
            << "'";
    }
    os << '\n';
}


bool ParticlePicture::write
(
    const std::filesystem::path& folder, const word& name
) const
{
    const PictureLayout layout(low_, high_, label(panels_.size()));
    writeData(folder, name, layout);
    const std::filesystem::path script = folder/(name + ".gp");
    writeFile(script, [&](std::ostream& os)
    {
        for (std::size_t k = 0; k < marks_.size(); ++k)
        {
            os << "$mark" << k << " << EOD\n";
            for (const vector& point : marks_[k].points)
            {
                os  << layout.unit*point.x() << ' '
                    << layout.unit*point.y() << '\n';
            }
            os << "EOD\n";
        }
        writeHead(os, name, layout);
        for (label k = 0; k < label(panels_.size()); ++k)
        {
            writePanel(os, name, layout, k);
        }
        os << "unset multiplot\n";
    });
    return runGnuplot(script);
}

} // namespace sph
