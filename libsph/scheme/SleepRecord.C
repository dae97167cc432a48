#include "scheme/SleepRecord.H"

#include "primitives/writeFile.H"

#include <iomanip>
#include <sstream>

namespace sph
{

static std::filesystem::path fileOf(const std::filesystem::path& timeFolder)
{
    return timeFolder/"uniform"/"sleep";
}

// FNV-1a of 64 bits
static word checksum(const std::string& text)
{
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text)
    {
        hash = (hash ^ std::uint8_t(c))*0x100000001b3;
    }
    std::ostringstream os;
    os << std::hex << std::setfill('0') << std::setw(16) << hash;
    return os.str();
}

static std::string text(const vector& v)
{
    std::ostringstream os;
    os << std::setprecision(17) << v.x() << ' ' << v.y();
    return os.str();
}

SleepRecord::SleepRecord(const Ground& ground, const dictionary& sleep)
:
    items_
    {
        {"gravity", "constant/g", checksum(text(ground.g))},
        {
            "material", "constant/granularProperties",
            checksum(ground.properties.text())
        },
        {
            "boundary", "constant/boundary",
            checksum(ground.boundary.text())
        },
        {
            "entries", "sleep in system/sphSolution", checksum(sleep.text())
        }
    }
{}

std::string SleepRecord::change
(
    const std::filesystem::path& timeFolder
) const
{
    const std::string time = timeFolder.filename().string();
    if (!std::filesystem::exists(fileOf(timeFolder)))
    {
        return "there is no " + time + "/uniform/sleep";
    }
    const dictionary dict = dictionary::fromFile(fileOf(timeFolder));
    for (const Item& item : items_)
    {
        if (dict.get<word>(item.key) != item.checksum)
        {
            return item.place + " has changed since time " + time;
        }
    }
    return "";
}

void SleepRecord::write
(
    const std::filesystem::path& timeFolder, const label active
) const
{
    writeFile
    (
        fileOf(timeFolder),
        [&](std::ostream& os)
        {
            os  << "FoamFile\n{\n"
                << "    version     2.0;\n"
                << "    format      ascii;\n"
                << "    class       dictionary;\n"
                << "    location    \""
                << timeFolder.filename().string() << "/uniform\";\n"
                << "    object      sleep;\n"
                << "}\n\n"
                << "active          " << active << ";\n";
            for (const Item& item : items_)
            {
                os  << '\n' << std::left << std::setw(16) << item.key
                    << '"' << item.checksum << "\";\n";
            }
        }
    );
}

label SleepRecord::readActive(const std::filesystem::path& timeFolder)
{
    return dictionary::fromFile(fileOf(timeFolder)).get<label>("active");
}

void SleepRecord::remove(const std::filesystem::path& timeFolder)
{
    std::error_code ignored;
    std::filesystem::remove(fileOf(timeFolder), ignored);
}

} // namespace sph
