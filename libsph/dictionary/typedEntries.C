// Entries read with a type, dimensions and a range.

#include "dictionary/contents.H"
#include "dictionary/valueReader.H"
#include "dictionary/valueText.H"

#include <cmath>

namespace sph
{

namespace
{

word notAChoice
(
    const word& key, const word& value, const wordList& choices
)
{
    const word meant = nearest(value, choices);
    return
        "Entry '" + key + "' has the unknown value '" + value + "'"
      + (meant.empty() ? "" : "\n did you mean '" + meant + "'?")
      + "\n\nValid values are :\n\n" + listOfWords(choices);
}

} // namespace


template<class T>
T dictionary::get(const word& key) const
{
    const Entry& entry = contents_->require(key);
    ValueReader reader(entry, contents_->where(entry));
    T value{};
    reader.read(value);
    reader.finish();
    return value;
}

template<class T>
T dictionary::getOrDefault(const word& key, const T& defaultValue) const
{
    if (found(key))
    {
        return get<T>(key);
    }
    contents_->recordDefault(key, sph::valueText(defaultValue));
    return defaultValue;
}

scalar dictionary::get
(
    const word& key, const dimensionSet& dims, const Range& range
) const
{
    const Entry& entry = contents_->require(key);
    ValueReader reader(entry, contents_->where(entry));
    const scalar factor = reader.readDimensions(dims);
    scalar value = 0;
    reader.read(value);
    reader.finish();
    value *= factor;
    if (!range.contains(value) || !std::isfinite(value))
    {
        fail
        (
            key,
            "Entry '" + key + "' is " + numberText(value) + " but must be "
          + range.str()
        );
    }
    return value;
}

scalar dictionary::getOrDefault
(
    const word& key,
    const scalar defaultValue,
    const dimensionSet& dims,
    const Range& range
) const
{
    if (found(key))
    {
        return get(key, dims, range);
    }
    contents_->recordDefault(key, numberText(defaultValue));
    return defaultValue;
}

vector dictionary::getVector
(
    const word& key, const dimensionSet& dims
) const
{
    const Entry& entry = contents_->require(key);
    ValueReader reader(entry, contents_->where(entry));
    const scalar factor = reader.readDimensions(dims);
    vector value;
    reader.read(value);
    reader.finish();
    value *= factor;
    if (!value.allFinite())
    {
        fail(key, "Entry '" + key + "' is not finite in SI units");
    }
    return value;
}

vector dictionary::getVectorOrDefault
(
    const word& key, const vector& defaultValue, const dimensionSet& dims
) const
{
    if (found(key))
    {
        return getVector(key, dims);
    }
    contents_->recordDefault(key, sph::valueText(defaultValue));
    return defaultValue;
}

word dictionary::getChoice(const word& key, const wordList& choices) const
{
    const word value = get<word>(key);
    for (const word& choice : choices)
    {
        if (choice == value)
        {
            return value;
        }
    }
    fail(key, notAChoice(key, value, choices));
}

word dictionary::getChoiceOrDefault
(
    const word& key, const word& defaultValue, const wordList& choices
) const
{
    if (found(key))
    {
        return getChoice(key, choices);
    }
    contents_->recordDefault(key, sph::valueText(defaultValue));
    return defaultValue;
}

#define instantiate(T) \
    template T dictionary::get<T>(const word&) const; \
    template T dictionary::getOrDefault<T>(const word&, const T&) const;

instantiate(scalar)
instantiate(label)
instantiate(bool)
instantiate(word)
instantiate(vector)
instantiate(dimensionSet)
instantiate(std::vector<scalar>)
instantiate(std::vector<label>)
instantiate(wordList)
instantiate(std::vector<vector>)

#undef instantiate

} // namespace sph
