#include "io/writeTimeFolder.H"

#include "primitives/error.H"

#include <algorithm>
#include <unistd.h>
#include <vector>

namespace sph
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* mark = ".tmp";

// The hidden folder, gone with this
struct Stage
{
    const fs::path folder;      // as it is to be
    const fs::path hidden;
    const fs::path path;        // as it is written

    explicit Stage(const fs::path& folder)
    :
        folder(folder),
        hidden
        (
            folder.parent_path()
           /(
                "." + folder.filename().string() + mark
              + std::to_string(::getpid())
            )
        ),
        path(hidden/folder.filename())
    {
        std::error_code error;
        fs::create_directories(path, error);
        check(error);
    }
    ~Stage()
    {
        std::error_code ignored;
        fs::remove_all(hidden, ignored);
    }

    void check(const std::error_code& error) const
    {
        if (error)
        {
            throw Error
            (
                "Cannot write " + folder.string() + ": " + error.message()
            );
        }
    }

    // What is said of a hidden file is said of the one that it was to be
    std::string clear(std::string message) const
    {
        const std::string name = path.string();
        const std::size_t at = message.find(name);
        return
            at == std::string::npos
          ? message : message.replace(at, name.size(), folder.string());
    }

    void commit() const
    {
        std::error_code error;
        if (!fs::exists(folder, error))
        {
            fs::rename(path, folder, error);
            check(error);
            return;
        }
        fs::remove(folder/"granular.vtp", error);
        check(error);
        for (const char* item : {"uniform", "walls.vtp", "granular.vtp"})
        {
            fs::remove_all(folder/item, error);
            check(error);
            if (fs::exists(path/item, error))
            {
                fs::rename(path/item, folder/item, error);
            }
            check(error);
        }
    }
};

// .0.05.tmp1234, as writeFile calls its files, too
bool isHidden(const fs::path& path)
{
    const std::string name = path.filename().string();
    const std::size_t at = name.rfind(mark);
    const auto isDigit = [](const char c) { return c >= '0' && c <= '9'; };
    return
        name[0] == '.' && at != std::string::npos && at > 1
     && std::all_of(name.begin() + at + 4, name.end(), isDigit);
}

// Whether a hidden folder holds what those of times hold
bool holdsTime(const fs::path& hidden)
{
    const std::string name = hidden.filename().string();
    std::error_code ignored;
    return fs::is_directory
    (
        hidden/name.substr(1, name.rfind(mark) - 1), ignored
    );
}

template<class Iterator>
void removeHidden
(
    const fs::path& folder,
    const std::function<bool(const fs::path&)>& unfinished
)
{
    std::vector<fs::path> found;
    std::error_code error;
    for
    (
        Iterator iter(folder, error), end;
        !error && iter != end;
        iter.increment(error)
    )
    {
        if (isHidden(iter->path()) && unfinished(iter->path()))
        {
            found.push_back(iter->path());
        }
    }
    for (const fs::path& path : found)
    {
        fs::remove_all(path, error);
    }
}

} // namespace


void writeTimeFolder
(
    const fs::path& folder, const std::function<void(const fs::path&)>& write
)
{
    const Stage stage(folder);
    try
    {
        write(stage.path);
    }
    catch (const Error& error)
    {
        throw Error(stage.clear(error.what()));
    }
    stage.commit();
}

void removeUnfinished(const fs::path& caseDir)
{
    removeHidden<fs::directory_iterator>(caseDir, holdsTime);
    for (const char* folder : {"VTK", "effective"})
    {
        removeHidden<fs::recursive_directory_iterator>
        (
            caseDir/folder,
            [](const fs::path& path) { return fs::is_regular_file(path); }
        );
    }
}

} // namespace sph
