#include "fuzz/Mutator.H"

#include <algorithm>
#include <cctype>

namespace sph
{

// Longer ones show nothing that these do not
static constexpr std::size_t longest = 200000;

Mutator::Mutator
(
    const std::vector<std::string>& corpus, const wordList& words,
    const std::uint64_t seed
)
:
    corpus_(corpus),
    words_(words),
    random_(seed)
{}

std::string Mutator::next(std::size_t& name)
{
    name = below(corpus_.size());
    std::string text = corpus_[name];
    for (std::size_t changes = 1 + below(1 + below(6)); changes > 0; --changes)
    {
        mutate(text);
        text.resize(std::min(text.size(), longest));
    }
    return text;
}

std::pair<std::size_t, std::size_t> Mutator::part
(
    const std::string& text, const std::size_t longest
)
{
    const std::size_t begin = below(text.size() + 1);
    const std::size_t most = std::min(longest, text.size() - begin);
    return {begin, begin + below(most + 1)};
}

std::pair<std::size_t, std::size_t> Mutator::token(const std::string& text)
{
    const auto inWord = [&](const std::size_t at)
    {
        const auto c = static_cast<unsigned char>(text[at]);
        return std::isalnum(c) || c == '.' || c == '_' || c == '-' || c == '+';
    };
    std::size_t begin = below(text.size());
    std::size_t end = std::min(begin + 1, text.size());
    if (begin < text.size() && inWord(begin))
    {
        while (begin > 0 && inWord(begin - 1))
        {
            --begin;
        }
        while (end < text.size() && inWord(end))
        {
            ++end;
        }
    }
    return {begin, end};
}

std::string Mutator::number()
{
    static const wordList extremes
    {
        "0", "-0", "1", "-1", "2147483647", "2147483648", "-2147483649",
        "9223372036854775807", "18446744073709551616", "1e15", "1e308",
        "-1e308", "1e309", "1e-308", "5e-324", "1e-400", "1e400", "nan",
        "inf", "-inf", "0x1f", "1e", "1.", ".5", "1.2.3", "--1", "00012",
        "1e999999999", "4294967295", "65536", "1000000", "100000000"
    };
    const std::size_t k = below(extremes.size() + 2);
    return
        k < extremes.size() ? extremes[k]
      : k == extremes.size() ? std::string(1 + below(500), '9') + "e-5"
      : std::to_string(std::int64_t(random_()) >> below(64));
}

void Mutator::mutate(std::string& text)
{
    switch (below(10))
    {
        case 0: case 1: case 2: mutateBytes(text); break;
        case 3: case 4: case 5: case 6: case 7: mutateTokens(text); break;
        case 8: splice(text); break;
        default: nest(text);
    }
}

void Mutator::mutateBytes(std::string& text)
{
    const auto [begin, end] = part(text, 100);
    switch (below(6))
    {
        case 0:
            if (!text.empty())
            {
                text[below(text.size())] ^= char(1 << below(8));
            }
            break;
        case 1:
            if (!text.empty())
            {
                text[below(text.size())] = char(random_());
            }
            break;
        case 2:
            text.insert(begin, 1, char(random_()));
            break;
        case 3:
            text.erase(begin, end - begin);
            break;
        case 4:
        {
            const std::string copy = text.substr(begin, end - begin);
            text.insert(below(text.size() + 1), copy);
            break;
        }
        default:
            text.resize(begin);
    }
}

void Mutator::mutateTokens(std::string& text)
{
    const auto [begin, end] = token(text);
    const std::string old = text.substr(begin, end - begin);
    switch (below(6))
    {
        case 0:
            text.erase(begin, end - begin);
            break;
        case 1:
            text.insert(end, ' ' + old);
            break;
        case 2:
            text.replace(begin, end - begin, number());
            break;
        case 3:
            text.replace(begin, end - begin, words_[below(words_.size())]);
            break;
        case 4:
            text.insert(begin, words_[below(words_.size())] + ' ');
            break;
        default:
        {
            // In place of another one
            const auto [to, toEnd] = token(text);
            text.replace(to, toEnd - to, old);
        }
    }
}

// A part of another one, or its end
void Mutator::splice(std::string& text)
{
    const std::string& other = corpus_[below(corpus_.size())];
    if (below(2) == 0)
    {
        text = text.substr(0, below(text.size() + 1))
          + other.substr(below(other.size() + 1));
        return;
    }
    const auto [begin, end] = part(other, 1000);
    text.insert(below(text.size() + 1), other, begin, end - begin);
}

// The same again and again, seldom very often
void Mutator::nest(std::string& text)
{
    const std::size_t most[] = {10, 100, 1000, 30000};
    const std::size_t times = below(most[below(4)]);
    std::string unit = words_[below(words_.size())] + (below(2) ? " " : "");
    if (below(4) == 0)
    {
        const auto [begin, end] = part(text, 30);
        unit = text.substr(begin, end - begin);
    }
    std::string repeated;
    for (std::size_t i = 0; i < times && repeated.size() < longest; ++i)
    {
        repeated += unit;
    }
    text.insert(below(text.size() + 1), repeated);
}

} // namespace sph
