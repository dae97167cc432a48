#include "pictures.H"

#include "functionObjects/gnuplot.H"
#include "primitives/writeFile.H"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <ostream>

namespace fs = std::filesystem;

namespace sph
{

static constexpr std::size_t maxPanels = 6;


// Evenly over the motion, and the last state
static std::vector<const Snapshot*> chosen
(
    const std::vector<Snapshot>& snapshots, const scalar stopTime
)
{
    const scalar first = snapshots.front().time;
    const scalar last =
        stopTime == stopTime ? stopTime : snapshots.back().time;
    std::vector<const Snapshot*> list;
    for (std::size_t k = 0; k < maxPanels; ++k)
    {
        const scalar time = first + (last - first)*k/(maxPanels - 1);
        const Snapshot* best = &snapshots.back();
        for (const Snapshot& snapshot : snapshots)
        {
            if (std::abs(snapshot.time - time) < std::abs(best->time - time))
            {
                best = &snapshot;
            }
        }
        if (k + 1 == maxPanels)
        {
            best = &snapshots.back();
        }
        if (list.empty() || best != list.back())
        {
            list.push_back(best);
        }
    }
    return list;
}


static std::string timeLabel(const scalar time, const scalar tc)
{
    std::string text = "t = " + shortText(time) + " s";
    if (tc == tc)
    {
        text += "  (" + shortText(std::round(100*time/tc)/100) + " t_c)";
    }
    return text;
}


static ParticlePicture::Mark column(const DepositGauge& gauge)
{
    const BedLine& bed = gauge.bed();
    const vector along = gauge.L0()*bed.direction;
    const vector normal(-bed.direction.y(), bed.direction.x());
    const vector up = gauge.H0()*normal;
    const vector foot = bed.origin + gauge.foot()*normal;
    const vector from = foot - (gauge.leftCounts() ? along : vector(0, 0));
    const vector to = foot + (gauge.rightCounts() ? along : vector(0, 0));
    return
    {
        {from, from + up, to + up, to}, "column at the start",
        "lc rgb '#404040' dt 3"
    };
}


static void addLaw
(
    const DepositGauge& gauge, const Report& report, ParticlePicture& picture
)
{
    const LawValue law = report.lawRunout();
    if (!law.given())
    {
        return;
    }
    const BedLine& bed = gauge.bed();
    const vector along = gauge.L0()*(1 + law.value)*bed.direction;
    const vector up =
        0.35*gauge.H0()*vector(-bed.direction.y(), bed.direction.x());
    const std::string style = "lc rgb '#d62728' dt 2";
    std::string title = "run-out of " + report.lawName();
    for (const scalar sign : {1, -1})
    {
        if (sign > 0 ? gauge.rightCounts() : gauge.leftCounts())
        {
            const vector foot = bed.origin + sign*along;
            picture.addMark({{foot, foot + up}, title, style});
            title.clear();
        }
    }
}


void drawCollapse
(
    const std::vector<Snapshot>& snapshots, const DepositGauge& gauge,
    const Report& report, const ParticlePicture::Options& options,
    const fs::path& folder
)
{
    ParticlePicture picture(options);
    for (const Snapshot* snapshot : chosen(snapshots, report.stopTime()))
    {
        Particles particles;
        snapshot->read(particles);
        picture.addPanel(particles, timeLabel(snapshot->time, gauge.tc()));
    }
    picture.addMark(column(gauge));
    addLaw(gauge, report, picture);
    if (picture.write(folder, "collapse"))
    {
        std::cout << "Picture: " << (folder/"collapse.png").string() << '\n';
    }
}


// The axes in units of L0: equal, around what is drawn
static void writeProfileHead
(
    std::ostream& os, const DepositGauge& gauge, const Report& report
)
{
    const LawValue law = report.lawRunout();
    const scalar farthest = 1.1 + std::max
    (
        report.greatestRunout(), law.given() ? law.value : 0
    );
    const scalar left = gauge.leftCounts() ? farthest : 0.1;
    const scalar right = gauge.rightCounts() ? farthest : 0.1;
    const scalar top = 1.08*report.greatestHeight()/gauge.L0();
    const scalar height = 860*top/(left + right) + 190;

    os  << "set terminal pngcairo size 1000,"
        << std::lround(std::clamp(height, 400.0, 1100.0))
        << " enhanced font 'DejaVu Sans,12'\n"
        << "set output 'profile.png'\nL0 = " << gauge.L0() << '\n'
        << "set xrange [" << -left << ':' << right << "]\n"
        << "set yrange [0:" << top << "]\nset size ratio -1\n"
        << "set xlabel 'x / L_0'\nset ylabel 'h / L_0'\n"
        << "set palette defined (0 '#440154', 1 '#365c8d', 2 '#1fa187',"
           " 3 '#a0da39')\nunset colorbox\n"
        << "set border 3 lc rgb '#404040'\n"
        << "set tics out nomirror scale 0.6\nset grid lc rgb '#e0e0e0'\n"
        << "set key below\n";
    for (const scalar sign : {1, -1})
    {
        if (law.given() && std::abs(law.value + 1) < (sign > 0 ? right : left))
        {
            const scalar x = sign*(1 + law.value);
            os  << "set arrow from " << x << ",0 to " << x << ',' << 0.4*top
                << " nohead lw 1.6 dt 2 lc rgb '#d62728'\n";
        }
    }
}


void drawProfiles
(
    const std::vector<Snapshot>& snapshots, const DepositGauge& gauge,
    const Report& report, const fs::path& folder
)
{
    const auto times = chosen(snapshots, report.stopTime());
    const fs::path script = folder/"profile.gp";
    writeFile(script, [&](std::ostream& os)
    {
        writeProfileHead(os, gauge, report);
        os << "set cbrange [0:" << times.size() << "]\nplot ";
        for (std::size_t k = 0; k < times.size(); ++k)
        {
            os  << "'profile_" << times[k]->name
                << ".dat' using ($1/L0):($2/L0) with lines lw "
                << (k + 1 == times.size() ? 3 : 1.6) << " lc palette cb " << k
                << " title '" << timeLabel(times[k]->time, gauge.tc())
                << "', \\\n     ";
        }
        os  << gauge.threshold()/gauge.L0()
            << " lw 1 dt 3 lc rgb '#404040' title 'threshold of the front'";
        if (report.lawRunout().given())
        {
            os  << ", \\\n     NaN lw 1.6 dt 2 lc rgb '#d62728' title"
                << " 'run-out of " << gnuplotText(report.lawName()) << "'";
        }
        os << '\n';
    });
    if (runGnuplot(script))
    {
        std::cout << "Picture: " << (folder/"profile.png").string() << '\n';
    }
}

} // namespace sph
