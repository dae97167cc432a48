#include "functionObjects/FieldColumns.H"

#include <map>

namespace sph
{

void FieldColumns::add(const FieldInfo& field)
{
    static const std::map<FieldKind, std::vector<std::string>> suffixes
    {
        {FieldKind::scalar, {""}},
        {FieldKind::vector, {".x", ".y"}},
        {FieldKind::symmTensor, {".xx", ".xy", ".yy"}},
        {FieldKind::tensor, {".xx", ".xy", ".yx", ".yy"}}
    };
    const auto& suffix = suffixes.at(field.kind);
    for (std::size_t c = 0; c < suffix.size(); ++c)
    {
        names.push_back(field.name + suffix[c]);
        values.push_back(field.components[c]);
    }
}

} // namespace sph
