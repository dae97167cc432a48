#include "primitives/writeFile.H"

#include "primitives/error.H"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <unistd.h>

namespace sph
{

namespace
{

[[noreturn]] void cannotWrite
(
    const std::filesystem::path& path, const std::string& reason
)
{
    throw Error("Cannot write " + path.string() + ": " + reason);
}

void writeTemporary
(
    const std::filesystem::path& path,
    const std::filesystem::path& temporary,
    const std::function<void(std::ostream&)>& write
)
{
    const auto check = [&](const std::ostream& os)
    {
        if (!os)
        {
            cannotWrite(path, std::strerror(errno ? errno : EIO));
        }
    };

    errno = 0;
    std::ofstream os(temporary, std::ios::binary);
    check(os);
    write(os);
    os.flush();
    check(os);
    os.close();
    check(os);
}

} // namespace


void writeFile
(
    const std::filesystem::path& path,
    const std::function<void(std::ostream&)>& write
)
{
    std::error_code error;
    const std::filesystem::path folder = path.parent_path();
    if (!folder.empty())
    {
        std::filesystem::create_directories(folder, error);
        if (error)
        {
            cannotWrite(path, error.message());
        }
    }

    const std::filesystem::path temporary =
        folder
       /(
            "." + path.filename().string() + ".tmp"
          + std::to_string(::getpid())
        );
    try
    {
        writeTemporary(path, temporary, write);
        std::filesystem::rename(temporary, path, error);
        if (error)
        {
            cannotWrite(path, error.message());
        }
    }
    catch (...)
    {
        std::filesystem::remove(temporary, error);
        throw;
    }
}

} // namespace sph
