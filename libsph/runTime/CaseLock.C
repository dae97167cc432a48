#include "runTime/CaseLock.H"

#include "primitives/error.H"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace sph
{

// Programs that are started from here do not inherit it
CaseLock::CaseLock(const std::filesystem::path& caseDir)
:
    descriptor_(::open(caseDir.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
    if (::access(caseDir.c_str(), W_OK | X_OK) != 0)
    {
        const std::string reason = std::strerror(errno);
        if (descriptor_ >= 0)
        {
            ::close(descriptor_);
        }
        throw Error
        (
            "Cannot write into the case " + caseDir.string() + ": " + reason
        );
    }
    if (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
    {
        const bool taken = errno == EWOULDBLOCK;
        ::close(descriptor_);
        descriptor_ = -1;
        if (taken)
        {
            throw Error
            (
                "Another program is running in the case " + caseDir.string()
              + "\n\nWait for its end, or stop it: both would write the same"
                " files"
            );
        }
    }
}

CaseLock::~CaseLock()
{
    if (descriptor_ >= 0)
    {
        ::close(descriptor_);
    }
}

} // namespace sph
