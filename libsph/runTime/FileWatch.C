#include "runTime/FileWatch.H"

#include <sys/stat.h>

namespace sph
{

bool FileWatch::Stamp::operator==(const Stamp& other) const
{
    return
        seconds == other.seconds && nanoseconds == other.nanoseconds
     && bytes == other.bytes && inode == other.inode;
}

FileWatch::FileWatch(const std::filesystem::path& file)
:
    file_(file)
{
    stamp_ = stamp();
}

FileWatch::Stamp FileWatch::stamp() const
{
    struct stat status{};
    if (file_.empty() || ::stat(file_.c_str(), &status) != 0)
    {
        return stamp_;
    }
    return
    {
        status.st_mtim.tv_sec, status.st_mtim.tv_nsec,
        status.st_size, status.st_ino
    };
}

bool FileWatch::changed()
{
    const Clock::time_point now = Clock::now();
    if (file_.empty() || now - lastLook_ < interval)
    {
        return false;
    }
    lastLook_ = now;

    const Stamp present = stamp();
    if (present == stamp_)
    {
        return false;
    }
    stamp_ = present;
    return true;
}

} // namespace sph
