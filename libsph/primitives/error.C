#include "primitives/error.H"

#include <algorithm>
#include <iostream>
#include <sstream>

namespace sph
{

Error::Error(const std::string& message)
:
    std::runtime_error(message)
{}

std::string Error::block() const
{
    return "--> FOAM FATAL ERROR:\n" + std::string(what()) + "\n";
}

IOError::IOError
(
    const std::string& message,
    const std::string& file,
    const label startLine,
    const label endLine
)
:
    Error(message),
    file_(file),
    startLine_(startLine),
    endLine_(std::max(startLine, endLine))
{}

std::string IOError::block() const
{
    std::ostringstream os;
    os << "--> FOAM FATAL IO ERROR:\n" << what() << "\n\nfile: " << file_;
    if (startLine_ > 0 && endLine_ > startLine_)
    {
        os << " from line " << startLine_ << " to line " << endLine_ << '.';
    }
    else if (startLine_ > 0)
    {
        os << " at line " << startLine_ << '.';
    }
    os << '\n';
    return os.str();
}

std::string listOfWords(wordList words)
{
    std::sort(words.begin(), words.end());
    std::ostringstream os;
    os << words.size() << "\n(\n";
    for (const word& w : words)
    {
        os << w << '\n';
    }
    os << ")\n";
    return os.str();
}

word nearest(const word& text, const wordList& candidates)
{
    // Levenshtein distance with one row
    const auto distance = [](const word& a, const word& b)
    {
        std::vector<std::size_t> row(b.size() + 1);
        for (std::size_t j = 0; j <= b.size(); ++j)
        {
            row[j] = j;
        }
        for (std::size_t i = 1; i <= a.size(); ++i)
        {
            std::size_t diagonal = row[0];
            row[0] = i;
            for (std::size_t j = 1; j <= b.size(); ++j)
            {
                const std::size_t up = row[j];
                const bool same =
                    std::tolower(static_cast<unsigned char>(a[i - 1]))
                 == std::tolower(static_cast<unsigned char>(b[j - 1]));
                row[j] = std::min
                ({
                    up + 1, row[j - 1] + 1, diagonal + (same ? 0 : 1)
                });
                diagonal = up;
            }
        }
        return row[b.size()];
    };

    word best;
    std::size_t bestDistance = std::max<std::size_t>(2, text.size()/3) + 1;
    for (const word& candidate : candidates)
    {
        // A beginning of three letters or more counts as a small slip
        const bool begins =
            text.size() > 2 && candidate.compare(0, text.size(), text) == 0;
        const std::size_t d =
            begins ? std::min<std::size_t>(2, distance(text, candidate))
          : distance(text, candidate);
        if (d < bestDistance)
        {
            best = candidate;
            bestDistance = d;
        }
    }
    return best;
}

int runMain(const std::string& application, const std::function<int()>& body)
{
    try
    {
        const int code = body();
        if (!std::cout.flush())
        {
            throw Error
            (
                "Cannot write all of the output: is the disk full, or the"
                " reader gone?"
            );
        }
        return code;
    }
    catch (const Error& error)
    {
        std::cout.flush();
        std::cerr << "\n\n" << error.block()
            << "\n    " << application << " exiting\n\n";
    }
    catch (const std::exception& error)
    {
        std::cout.flush();
        std::cerr << "\n\n--> FOAM FATAL ERROR:\n" << error.what()
            << "\n\n    " << application << " exiting\n\n";
    }
    return 1;
}

} // namespace sph
