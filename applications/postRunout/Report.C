#include "Report.H"

#include "deposit/history.H"
#include "table.H"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

namespace sph
{

static const wordList rowColumns
{
    "Time", "t/tc", "frontLeft", "frontRight", "runout", "height",
    "heightAtOrigin", "mobilised", "kinetic", "potential", "elastic",
    "dissipated", "centreX", "centreY", "volume"
};


word Report::Comparison::verdict() const
{
    if (!law.given() || !(law.band == law.band))
    {
        return "-";
    }
    return std::abs(error()) <= law.band ? "pass" : "FAIL";
}


Report::Report
(
    const dictionary& dict, const DepositGauge& gauge,
    const Energies& start, OutputFolder& folder
)
:
    gauge_(gauge),
    start_(start),
    lawName_(dict.getOrDefault<word>("law", "none")),
    law_(RunoutLaw::New(dict)),
    tolerance_
    (
        dict.getOrDefault
        (
            {"tolerance", "change of the run-out that is none"}, 1e-3,
            dimless, Range::positive()
        )
    ),
    folder_(folder)
{
    const dictionary& bands = dict.subOrEmptyDict
    (
        {"band", "relative bands about the law; else its own scatter"}
    );
    for
    (
        const Key& quantity :
        {
            Key("runout", "band of the run-out", "0.1"),
            Key("height", "band of the height", "0.05"),
            Key("stopTime", "band of the time of stopping", "0.1")
        }
    )
    {
        if (bands.found(quantity))
        {
            bands_.emplace_back
            (
                quantity.name, bands.get(quantity, dimless, Range::positive())
            );
        }
    }
}


void Report::begin()
{
    rows_ = std::make_unique<DataFile>
    (
        folder_.path()/"runout.dat",
        wordList
        {
            "Time [s], lengths [m], energies [J/m], volume [m2]",
            "L0 " + shortText(gauge_.L0()) + "  H0 " + shortText(gauge_.H0())
          + "  threshold " + shortText(gauge_.threshold())
        },
        rowColumns
    );
    std::cout
        << "L0 = " << gauge_.L0() << " m, H0 = " << gauge_.H0()
        << " m, a = H0/L0 = " << aspectRatio()
        << ", tc = sqrt(H0/g) = " << gauge_.tc() << " s\n"
        << "Front where the thickness falls below "
        << 1000*gauge_.threshold() << " mm\n\n"
        << "    t [s]    t/tc   front [m]   run-out   height [m]"
           "   mobilised   kinetic [J/m]\n";
}


void Report::add
(
    const scalar time, const word& name,
    const Particles& particles, const Energies& now
)
{
    if (!rows_)
    {
        begin();
    }
    last_ = std::make_unique<Deposit>(gauge_.measure(particles));
    mobilised_ = gauge_.mobilised(particles);
    const scalar lost = start_.total() - now.total();
    lost_ = lost/(start_.potential - now.potential);
    times_.push_back(time);
    runouts_.push_back(last_->runout);
    heights_.push_back(last_->height);

    cell(time, 9, 4);
    cell(time/gauge_.tc(), 8, 2);
    cell(last_->reach, 12, 4);
    cell(last_->runout, 10, 3);
    cell(last_->height, 13, 4);
    cell(mobilised_, 12, 3);
    scientific(now.kinetic, 16);
    std::cout << std::endl;

    rows_->write
    ({
        time, time/gauge_.tc(), last_->front.left, last_->front.right,
        last_->runout, last_->height, last_->heightAtOrigin, mobilised_,
        now.kinetic, now.potential - start_.potential, now.elastic, lost,
        now.centreOfMass.x(), now.centreOfMass.y(), last_->profile.volume()
    });
    writeProfile(last_->profile, name);
}


void Report::writeProfile(const Profile& profile, const word& name)
{
    DataFile file
    (
        folder_.path()/("profile_" + name + ".dat"),
        {"Surface profile [m], x from the origin along the bed"}, {"x", "h"}
    );
    for (label bin = 0; bin < profile.size(); ++bin)
    {
        file.write({profile.x(bin), profile.h(bin)});
    }
}


scalar Report::stopTime() const
{
    return settlingTime(times_, runouts_, tolerance_);
}


scalar Report::greatestRunout() const
{
    return std::max(0.0, *std::max_element(runouts_.begin(), runouts_.end()));
}


scalar Report::greatestHeight() const
{
    return *std::max_element(heights_.begin(), heights_.end());
}


std::vector<Report::Comparison> Report::comparisons() const
{
    const scalar a = aspectRatio();
    std::vector<Comparison> list
    {
        {"runout", last_->runout, law_->runout(a)},
        {"height", last_->height/gauge_.L0(), law_->height(a)},
        {"stopTime", stopTime()/gauge_.tc(), law_->stopTime(a)}
    };
    for (Comparison& item : list)
    {
        for (const auto& [quantity, band] : bands_)
        {
            if (quantity == item.quantity)
            {
                item.law.band = band;
            }
        }
    }
    return list;
}


std::pair<label, label> Report::summarise()
{
    std::cout
        << "\nAt t = " << times_.back() << " s, law: " << lawName_ << "\n\n"
        << "quantity              measured      law   error %   band %"
           "   verdict\n";
    DataFile file
    (
        folder_.path()/"summary.dat", {"law " + lawName_},
        {"quantity", "verdict", "measured", "law", "errorPercent",
         "bandPercent"}
    );

    label passed = 0, failed = 0;
    for (const Comparison& item : comparisons())
    {
        const word verdict = item.verdict();
        passed += verdict == "pass";
        failed += verdict == "FAIL";
        const word title =
            item.quantity == "runout" ? "run-out (Lf-L0)/L0"
          : item.quantity == "height" ? "height Hf/L0" : "front stops at t/tc";
        std::cout << std::left << std::setw(20) << title;
        cell(item.measured, 10, 3);
        cell(item.law.value, 9, 3);
        cell(100*item.error(), 10, 1, true);
        cell(100*item.law.band, 9, 1);
        std::cout << std::setw(10) << verdict;
        std::cout
            << (item.law.note.empty() ? "" : "   (" + item.law.note + ")")
            << '\n';
        file.write
        (
            {item.quantity, verdict},
            {
                item.measured, item.law.value,
                100*item.error(), 100*item.law.band
            }
        );
    }
    printDetails();
    return {passed, failed};
}


void Report::printDetails() const
{
    std::cout << std::setprecision(4);
    const scalar thick = gauge_.runout(*last_, 3*gauge_.threshold());
    if (std::isfinite(thick))
    {
        std::cout << "\nRun-out with three times the threshold: " << thick;
    }
    std::cout << "\nMobilised fraction of the mass: " << mobilised_
        << "\nDissipated over released potential energy: ";
    cell(lost_, 0, 3);
    if (times_.size() < 2)
    {
        std::cout << "\nThe time of stopping takes more than one time";
    }
    else if (stopTime() != stopTime())
    {
        std::cout
            << "\nThe front has not come to rest within these times: its"
               " change exceeds\n" << tolerance_ << " L0";
    }
    else
    {
        std::cout
            << "\nThe time of stopping is known to the interval of writing";
    }
    std::cout << "\n\n" << std::setprecision(6);
}

} // namespace sph
