#include "deposit/magnitude.H"

#include <cmath>

namespace sph
{

scalar magnitude(const FieldInfo& field, const label i)
{
    const auto& c = field.components;
    const auto sqr = [&](const label k)
    {
        return (*c[k])[i]*(*c[k])[i];
    };
    switch (field.kind)
    {
        case FieldKind::scalar:
            return (*c[0])[i];
        case FieldKind::vector:
            return std::sqrt(sqr(0) + sqr(1));
        case FieldKind::symmTensor:
            return std::sqrt(0.5*(sqr(0) + 2*sqr(1) + sqr(2)));
        default:
            return std::sqrt(0.5*(sqr(0) + sqr(1) + sqr(2) + sqr(3)));
    }
}


const FieldInfo& findField
(
    const Particles& particles, const word& name,
    const dictionary& dict, const word& entry
)
{
    wordList names;
    for (const FieldInfo& field : particles.fields())
    {
        if (field.name == name)
        {
            return field;
        }
        names.push_back(field.name);
    }
    dict.fail
    (
        entry,
        "Unknown field " + name + "\n\nValid fields :\n\n" + listOfWords(names)
    );
}


std::string magnitudeName(const FieldInfo& field)
{
    return
        field.kind == FieldKind::scalar ? field.name : "|" + field.name + "|";
}

} // namespace sph
