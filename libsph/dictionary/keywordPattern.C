#include "dictionary/keywordPattern.H"

#include <cctype>
#include <stdexcept>

namespace sph
{

// Characters, times all numbers in braces
static std::size_t patternSize(const std::string& text)
{
    constexpr std::size_t most = 1000000;
    std::size_t size = text.size();
    for (std::size_t at = 0; at < text.size() && size < most; ++at)
    {
        const bool opens = text[at] == '{' || text[at] == ',';
        std::size_t times = 0;
        while
        (
            opens && at + 1 < text.size() && times < most
         && std::isdigit(static_cast<unsigned char>(text[at + 1]))
        )
        {
            times = 10*times + (text[++at] - '0');
        }
        size *= times > 1 ? times : 1;
    }
    return size;
}

std::regex keywordPattern(const std::string& text)
{
    if (patternSize(text) > 2000)
    {
        throw std::invalid_argument("is too large for a regular expression");
    }
    try
    {
        // Without __polynomial libstdc++ tries all ways to match, one by one
        return std::regex
        (
            text, std::regex::ECMAScript | std::regex_constants::__polynomial
        );
    }
    catch (const std::regex_error&)
    {
        throw std::invalid_argument("is not a regular expression");
    }
}

} // namespace sph
