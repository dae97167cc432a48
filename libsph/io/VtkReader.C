#include "io/VtkReader.H"

#include <string>
#include <vtkObjectFactory.h>
#include <vtkXMLDataElement.h>

namespace sph
{

namespace
{

// The first array below element whose type is unknown, nullptr if there is none
vtkXMLDataElement* arrayWithoutType(vtkXMLDataElement& element)
{
    const std::string kind = element.GetName() ? element.GetName() : "";
    int type = 0;
    if
    (
        (kind == "DataArray" || kind == "Array")
     && !element.GetWordTypeAttribute("type", type)
    )
    {
        return &element;
    }
    for (int i = 0; i < element.GetNumberOfNestedElements(); ++i)
    {
        if (auto* found = arrayWithoutType(*element.GetNestedElement(i)))
        {
            return found;
        }
    }
    return nullptr;
}

} // namespace


vtkStandardNewMacro(VtkReader);

int VtkReader::ReadVTKFile(vtkXMLDataElement* root)
{
    if (auto* array = arrayWithoutType(*root))
    {
        const char* name = array->GetAttribute("Name");
        vtkErrorMacro("The type of array " << (name ? name : "?") << " is unknown");
        return 0;
    }
    return Superclass::ReadVTKFile(root);
}

} // namespace sph
