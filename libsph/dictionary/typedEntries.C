// Entries read with a type, dimensions and a range.

#include "dictionary/contents.H"
#include "dictionary/valueReader.H"
#include "dictionary/valueText.H"

#include <algorithm>
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

std::string kindName(scalar) { return "number"; }
std::string kindName(label) { return "whole number"; }
std::string kindName(bool) { return "yes or no"; }
std::string kindName(const word&) { return "word"; }
std::string kindName(const vector&) { return "vector"; }
std::string kindName(const dimensionSet&) { return "dimensions"; }

template<class T>
std::string kindName(const std::vector<T>&)
{
    return "list";
}

} // namespace


template<class T>
T dictionary::get(const Key& key) const
{
    contents_->noteKind(key, kindName(T()));
    const Entry& entry = contents_->require(key);
    ValueReader reader(entry, contents_->where(entry));
    T value{};
    reader.read(value);
    reader.finish();
    return value;
}

template<class T>
T dictionary::getOrDefault(const Key& key, const T& defaultValue) const
{
    contents_->noteKind(key, kindName(T())).defaultValue =
        sph::valueText(defaultValue);
    return found(key) ? get<T>(key) : defaultValue;
}

scalar dictionary::get
(
    const Key& key, const dimensionSet& dims, const Range& range
) const
{
    Lookup& lookup = contents_->noteKind(key, kindName(scalar()));
    lookup.dims = dims;
    lookup.range = range;
    const Entry& entry = contents_->require(key);
    ValueReader reader(entry, contents_->where(entry));
    const scalar factor = reader.readDimensions(dims);
    scalar value = 0;
    reader.read(value);
    reader.finish();
    value *= factor;
    checkRange(key, value, range);
    return value;
}

scalar dictionary::getOrDefault
(
    const Key& key,
    const scalar defaultValue,
    const dimensionSet& dims,
    const Range& range
) const
{
    Lookup& lookup = contents_->noteKind(key, kindName(scalar()));
    lookup.dims = dims;
    lookup.range = range;
    lookup.defaultValue = numberText(defaultValue);
    return found(key) ? get(key, dims, range) : defaultValue;
}

label dictionary::getLabel(const Key& key, const Range& range) const
{
    contents_->noteKind(key, kindName(label())).range = range;
    const label value = get<label>(key);
    checkRange(key, value, range);
    return value;
}

label dictionary::getLabelOrDefault
(
    const Key& key, const label defaultValue, const Range& range
) const
{
    Lookup& lookup = contents_->noteKind(key, kindName(label()));
    lookup.range = range;
    lookup.defaultValue = sph::valueText(defaultValue);
    return found(key) ? getLabel(key, range) : defaultValue;
}

vector dictionary::getVector
(
    const Key& key, const dimensionSet& dims
) const
{
    contents_->noteKind(key, kindName(vector())).dims = dims;
    const Entry& entry = contents_->require(key);
    ValueReader reader(entry, contents_->where(entry));
    const scalar factor = reader.readDimensions(dims);
    vector value;
    reader.read(value);
    reader.finish();
    value *= factor;
    if (!value.allFinite())
    {
        fail(key.name, "Entry '" + key.name + "' is not finite in SI units");
    }
    return value;
}

vector dictionary::getVectorOrDefault
(
    const Key& key, const vector& defaultValue, const dimensionSet& dims
) const
{
    Lookup& lookup = contents_->noteKind(key, kindName(vector()));
    lookup.dims = dims;
    lookup.defaultValue = sph::valueText(defaultValue);
    return found(key) ? getVector(key, dims) : defaultValue;
}

word dictionary::getChoice(const Key& key, const wordList& choices) const
{
    contents_->note(key).choices = choices;
    const word value = get<word>(key);
    if (std::find(choices.begin(), choices.end(), value) == choices.end())
    {
        fail(key.name, notAChoice(key.name, value, choices));
    }
    return value;
}

word dictionary::getChoiceOrDefault
(
    const Key& key, const word& defaultValue, const wordList& choices
) const
{
    Lookup& lookup = contents_->noteKind(key, kindName(word()));
    lookup.choices = choices;
    lookup.defaultValue = sph::valueText(defaultValue);
    return found(key) ? getChoice(key, choices) : defaultValue;
}

void dictionary::checkRange
(
    const Key& key, const scalar value, const Range& range
) const
{
    if (!range.contains(value) || !std::isfinite(value))
    {
        fail
        (
            key.name,
            "Entry '" + key.name + "' is " + numberText(value)
          + " but must be " + range.str()
        );
    }
}

#define instantiate(T) \
    template T dictionary::get<T>(const Key&) const; \
    template T dictionary::getOrDefault<T>(const Key&, const T&) const;

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
