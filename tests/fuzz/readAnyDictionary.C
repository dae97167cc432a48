#include "fuzz/targets.H"

#include "dictionary/dictionary.H"

#include <cmath>
#include <sstream>

namespace sph
{

namespace
{

void expectFinite(const scalar value, const word& key)
{
    if (!std::isfinite(value))
    {
        throw std::logic_error("entry " + key + " is read but not finite");
    }
}

void expectFinite(const vector& value, const word& key)
{
    expectFinite(value.x(), key);
    expectFinite(value.y(), key);
}

template<class T>
void expectFinite(const std::vector<T>& values, const word& key)
{
    for (const T& value : values)
    {
        expectFinite(value, key);
    }
}

template<class Read>
void tryTo(const Read& read)
{
    try
    {
        read();
    }
    catch (const Error&)
    {}
}

void readAll(const dictionary& dict);

void readEntry(const dictionary& dict, const word& key)
{
    tryTo([&] { expectFinite(dict.get<scalar>(key), key); });
    tryTo([&] { dict.get<label>(key); });
    tryTo([&] { dict.get<bool>(key); });
    tryTo([&] { dict.get<word>(key); });
    tryTo([&] { expectFinite(dict.get<vector>(key), key); });
    tryTo([&] { expectFinite(dict.get<std::vector<scalar>>(key), key); });
    tryTo([&] { dict.get<std::vector<label>>(key); });
    tryTo([&] { dict.get<wordList>(key); });
    tryTo([&] { expectFinite(dict.get<std::vector<vector>>(key), key); });
    tryTo([&] { dict.get<dimensionSet>(key); });
    tryTo([&] { expectFinite(dict.get(key, dimless), key); });
    tryTo([&] { expectFinite(dict.get(key, dimDensity), key); });
    tryTo([&] { expectFinite(dict.getVector(key, dimLength), key); });
    tryTo([&] { dict.getChoice(key, {"yes", "none", "binary"}); });
    tryTo([&] { dict.getOrDefault<word>("no" + key, "default"); });
    tryTo([&]
    {
        for (const auto& [name, below] : dict.dictList(key))
        {
            readAll(*below);
        }
    });
    dict.valueText(key);
}

void readAll(const dictionary& dict)
{
    for (const word& key : dict.toc())
    {
        if (dict.isDict(key))
        {
            readAll(dict.subDict(key));
        }
        else
        {
            readEntry(dict, key);
        }
    }
}

std::string effective(const dictionary& dict)
{
    std::ostringstream os;
    dict.writeEffective(os);
    return os.str();
}

} // namespace


void readAnyDictionary(const std::string& text, const std::string& name)
{
    const dictionary dict = dictionary::fromString(text, name);
    tryTo([&] { dict.refuseUnused(); });

    // As it was understood, whoever reads it first
    const std::string before = effective(dict);
    std::string again;
    try
    {
        again = effective(dictionary::fromString(before, name));
    }
    catch (const Error& error)
    {
        throw std::logic_error
        (
            "what is written cannot be read: " + error.block() + before
        );
    }
    if (again != before)
    {
        throw std::logic_error
        (
            "written and read again:\n" + before + "\n* * *\n" + again
        );
    }
    readAll(dict);
    tryTo([&] { dict.fail("key", "message"); });
}

} // namespace sph
