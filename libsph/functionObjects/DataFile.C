#include "functionObjects/DataFile.H"

#include "primitives/error.H"

#include <cerrno>
#include <cstring>
#include <iomanip>
#include <sstream>

namespace sph
{

static constexpr int columnWidth = 16;


OutputFolder::OutputFolder
(
    const std::filesystem::path& caseDir,
    const word& name, const word& startTime
)
:
    parent_(caseDir/"postProcessing"/name),
    startTime_(startTime)
{}


const std::filesystem::path& OutputFolder::path()
{
    namespace fs = std::filesystem;
    if (folder_.empty())
    {
        fs::path folder = parent_/startTime_;
        std::error_code error;
        for (label i = 1; fs::exists(folder) && !fs::is_empty(folder); ++i)
        {
            folder = parent_/(startTime_ + "_" + std::to_string(i));
        }
        fs::create_directories(folder, error);
        if (error)
        {
            throw Error
            (
                "Cannot make the folder " + folder.string() + ": "
              + error.message()
            );
        }
        folder_ = folder;
    }
    return folder_;
}


DataFile::DataFile
(
    const std::filesystem::path& path,
    const wordList& comments, const wordList& columns
)
:
    path_(path)
{
    errno = 0;
    os_.open(path);
    if (!os_)
    {
        fail(errno);
    }
    for (const word& comment : comments)
    {
        os_ << "# " << comment << '\n';
    }
    os_ << '#';
    label indent = 1;
    for (const word& column : columns)
    {
        os_ << ' ' << std::left << std::setw(columnWidth - indent) << column;
        indent = 0;
    }
    endRow();
}


void DataFile::write(const std::vector<scalar>& row)
{
    write({}, row);
}


void DataFile::write(const wordList& words, const std::vector<scalar>& row)
{
    for (const word& entry : words)
    {
        os_ << ' ' << std::left << std::setw(columnWidth) << entry;
    }
    os_ << std::setprecision(9);
    for (const scalar value : row)
    {
        os_ << ' ' << std::left << std::setw(columnWidth) << value;
    }
    endRow();
}


void DataFile::endRow()
{
    os_ << '\n';
    errno = 0;
    os_.flush();
    if (!os_)
    {
        // No half row stays
        const int reason = errno;
        os_.close();
        std::error_code ignored;
        std::filesystem::resize_file(path_, size_, ignored);
        fail(reason);
    }
    size_ = os_.tellp();
}


void DataFile::fail(const int reason) const
{
    throw Error
    (
        "Cannot write " + path_.string() + ": "
      + std::strerror(reason ? reason : EIO)
    );
}


word shortText(const scalar value)
{
    std::ostringstream os;
    os << std::setprecision(9) << value;
    return os.str();
}

} // namespace sph
