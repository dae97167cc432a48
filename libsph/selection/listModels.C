#include "selection/listModels.H"

#include "selection/Selectable.H"

#include <iomanip>
#include <ostream>

namespace sph
{

void listModels(std::ostream& os)
{
    for (const auto& [family, table] : SelectionTables::all())
    {
        listModels(os, family);
    }
}


void listModels(std::ostream& os, const std::string& family)
{
    os << family << '\n';
    for (const auto& [keyword, description] : SelectionTables::all()[family])
    {
        os << "    " << std::left << std::setw(34) << keyword
            << description << '\n';
    }
    os << '\n';
}

} // namespace sph
