// Fields across a layer, averaged along it, and how far they are from a
// solution or an experiment.
//
//     profile
//     {
//         type       profile;
//         fields     (U p s);          // components U.x U.y p s.xx ...
//         origin     (0 0 0);          // default
//         direction  (0 1 0);          // default: across the layer
//         width      5e-4;             // of a bin [m]; default: the spacing
//         reference                    // optional
//         {
//             file     "validation/bagnold.csv";      // from the case
//             columns  (y_m u_m_s);    // distance, value
//             field    U.x;
//             where    { theta_deg 24; }  // only rows with these values
//             time     t_s;            // optional: column with the time
//             band     0.01;           // optional: of the error in L2
//         }
//         executeControl runTime;  executeInterval 0.5;
//     }
//
// Means of bins: deposit/LayerProfile.H. With f the mean of a bin, r the
// reference at its place (cubic between the rows) and V its volume
//
//     L2 = sqrt(sum V (f - r)^2 / sum V r^2)
//
// Bins outside the rows of the reference do not count. Without the entry time
// every call is compared, otherwise those at a time of the file.
//
// Writes profile_<time>.dat at every call and reference.dat, a row each
// comparison: verdict (passed, failed; none without band), Time, the norms
// sqrt(sum V f^2/sum V) measured and of the reference, L2 and band in %.

#include "deposit/LayerProfile.H"
#include "functionObjects/DataFile.H"
#include "functionObjects/FieldColumns.H"
#include "functionObjects/FunctionObject.H"
#include "functionObjects/ProfileReference.H"

#include <algorithm>
#include <iostream>
#include <optional>

namespace sph
{
namespace
{

class profile : public FunctionObject
{
    const Particles& particles_;
    FieldColumns columns_;
    vector origin_;
    vector direction_;
    scalar width_;
    std::optional<ProfileReference> reference_;
    std::size_t compared_ = 0;      // index of the column
    word name_;
    OutputFolder folder_;
    std::unique_ptr<DataFile> errors_;

    static vector readDirection(const dictionary& dict)
    {
        const vector direction =
            dict.getVectorOrDefault
            (
                {"direction", "across the layer"}, vector(0, 1), dimless
            );
        if (!(direction.norm() > 0))
        {
            dict.fail("direction", "The direction must not be zero");
        }
        return direction.normalized();
    }

    void readReference(const dictionary& dict, const Scene& scene)
    {
        reference_.emplace(dict, scene.caseDir);
        const auto& names = columns_.names;
        const auto found =
            std::find(names.begin(), names.end(), reference_->field());
        if (found == names.end())
        {
            dict.fail
            (
                "field", "Unknown component " + reference_->field()
              + "\n\nValid components :\n\n" + listOfWords(names)
            );
        }
        compared_ = found - names.begin();
    }

public:
    profile(const dictionary& dict, const word& name, const Scene& scene)
    :
        particles_(scene.particles),
        origin_
        (
            dict.getVectorOrDefault
            (
                {"origin", "where distances count from"}, vector::Zero(),
                dimLength
            )
        ),
        direction_(readDirection(dict)),
        width_
        (
            dict.getOrDefault
            (
                {"width", "width of a bin; else dx", "5e-4"},
                particles_.spacing(), dimLength, Range::positive()
            )
        ),
        name_(name),
        folder_(scene.caseDir, name, scene.startTimeName)
    {
        const Key fields("fields", "fields to average", "(U p)");
        for (const word& field : dict.get<wordList>(fields))
        {
            columns_.add(findField(scene, field, dict, "fields"));
        }
        if (dict.found({"reference", "what it is compared with", "{}"}))
        {
            readReference(dict.subDict("reference"), scene);
        }
    }

    void execute(const scalar time, std::string&) override
    {
        const LayerProfile layer
        (
            particles_, columns_.values, origin_, direction_, width_
        );
        write(layer, time);
        const ReferenceCurve* const curve =
            reference_ ? reference_->at(time) : nullptr;
        if (curve)
        {
            compare(layer, *curve, time);
        }
    }

private:
    void write(const LayerProfile& layer, const scalar time)
    {
        wordList names{"z", "volume"};
        names.insert
        (
            names.end(), columns_.names.begin(), columns_.names.end()
        );
        DataFile file
        (
            folder_.path()/("profile_" + shortText(time) + ".dat"),
            {"Time [s] " + shortText(time) + "; SI units"}, names
        );
        for (const LayerProfile::Bin& bin : layer.bins())
        {
            std::vector<scalar> row{bin.z, bin.volume};
            row.insert(row.end(), bin.values.begin(), bin.values.end());
            file.write(row);
        }
    }

    void compare
    (
        const LayerProfile& layer, const ReferenceCurve& curve,
        const scalar time
    )
    {
        scalar volume = 0, ff = 0, rr = 0, dd = 0;
        for (const LayerProfile::Bin& bin : layer.bins())
        {
            if (curve.covers(bin.z))
            {
                const scalar f = bin.values[compared_], r = curve(bin.z);
                volume += bin.volume;
                ff += bin.volume*f*f;
                rr += bin.volume*r*r;
                dd += bin.volume*(f - r)*(f - r);
            }
        }
        if (!errors_)
        {
            errors_ = std::make_unique<DataFile>
            (
                folder_.path()/"reference.dat",
                wordList{"Component " + reference_->field() + ", SI units; L2"
                " relative to the norm of the reference"},
                wordList
                {
                    "verdict", "Time", "measured", "reference", "L2%", "band%"
                }
            );
        }
        const scalar L2 = std::sqrt(dd/rr);
        const word verdict = reference_->verdict(L2);
        errors_->write
        (
            {verdict},
            {
                time, std::sqrt(ff/volume), std::sqrt(rr/volume), 100*L2,
                100*reference_->band()
            }
        );
        std::cout
            << name_ << ": " << reference_->field() << " off the reference by "
            << 100*L2 << " % in L2"
            << (verdict == "none" ? "" : ", " + verdict) << '\n';
    }
};

static const FunctionObject::Add<profile> add
(
    "profile", "fields across a layer, and their error against a reference"
);

} // namespace
} // namespace sph
