#include "io/VtkReader.H"

#include "io/VtkParser.H"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>
#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkXMLDataElement.h>

namespace sph
{

namespace
{

std::string nameOf(vtkXMLDataElement& element)
{
    return element.GetName() ? element.GetName() : "";
}

std::vector<vtkXMLDataElement*> below(vtkXMLDataElement& element)
{
    std::vector<vtkXMLDataElement*> elements;
    for (int i = 0; i < element.GetNumberOfNestedElements(); ++i)
    {
        elements.push_back(element.GetNestedElement(i));
    }
    return elements;
}

// What an attribute says, of which there may be none
double number
(
    vtkXMLDataElement& element, const char* attribute, const double otherwise
)
{
    double value = otherwise;
    element.GetScalarAttribute(attribute, value);
    return value;
}

// Leaves out what nobody here asks for: lists of words, keys of VTK, data of
// cells and, as a rule, cells
void prune(vtkXMLDataElement& element, const bool cells)
{
    std::set<std::string> unwanted{"CellData", "Array", "InformationKey"};
    for (const std::string kind : {"Verts", "Lines", "Strips", "Polys"})
    {
        if (cells)
        {
            continue;
        }
        unwanted.insert(kind);
        if (nameOf(element) == "Piece")
        {
            element.SetIntAttribute(("NumberOf" + kind).c_str(), 0);
        }
    }
    for (vtkXMLDataElement* part : below(element))
    {
        if (unwanted.count(nameOf(*part)) > 0)
        {
            element.RemoveNestedElement(part);
        }
        else
        {
            prune(*part, cells);
        }
    }
}

// Values of the arrays below an element, each with so many tuples; error: why
// one of them cannot be read
double valuesBelow
(
    vtkXMLDataElement& element, double tuples, std::string& error
)
{
    double count = 0;
    if (nameOf(element) == "Piece")
    {
        tuples = number(element, "NumberOfPoints", 0);
    }
    for (vtkXMLDataElement* part : below(element))
    {
        count += valuesBelow(*part, tuples, error);
    }
    if (nameOf(element) != "DataArray")
    {
        return count;
    }

    const char* given = element.GetAttribute("Name");
    const std::string name = given ? given : "?";
    int type = 0;
    if (!element.GetWordTypeAttribute("type", type))
    {
        error = "The type of array " + name + " is unknown";
    }
    const double components = number(element, "NumberOfComponents", 1);
    tuples = number(element, "NumberOfTuples", tuples);
    if (!(components >= 1 && components <= 100 && tuples >= 0))
    {
        error = "The sizes of array " + name + " are wrong";
    }
    return count + components*tuples;
}

// Appended data may stand between the parser's end and that of the file
bool hasEnd(const char* file)
{
    std::ifstream is(file, std::ios::binary | std::ios::ate);
    const std::streamoff tail = std::min<std::streamoff>(is.tellg(), 1000);
    std::string text(std::size_t(std::max<std::streamoff>(tail, 0)), ' ');
    is.seekg(-tail, std::ios::end);
    is.read(text.data(), tail);
    return text.find("</VTKFile>") != std::string::npos;
}

} // namespace


vtkStandardNewMacro(VtkReader);

void VtkReader::CreateXMLParser()
{
    if (XMLParser)
    {
        DestroyXMLParser();
    }
    XMLParser = VtkParser::New();
}

int VtkReader::ReadVTKFile(vtkXMLDataElement* root)
{
    std::string error;
    if (static_cast<VtkParser*>(XMLParser)->tooDeep())
    {
        error = "The elements are nested too deeply";
    }
    prune(*root, cells_);

    // A value takes a byte at least, a thousandth of one if compressed
    std::error_code ignored;
    const auto bytes = std::filesystem::file_size(FileName, ignored);
    static_cast<VtkParser*>(XMLParser)->setFileSize(bytes);
    const double size = double(bytes);
    const double most = size*(root->GetAttribute("compressor") ? 1100 : 1);
    if (valuesBelow(*root, 0, error) > most && error.empty())
    {
        error = "The file is too short for its sizes";
    }
    if (!hasEnd(FileName))
    {
        error = "The end of the file is missing";
    }
    if (!error.empty())
    {
        vtkErrorMacro(<< error);
        return 0;
    }
    return Superclass::ReadVTKFile(root);
}

int VtkReader::RequestData
(
    vtkInformation* request, vtkInformationVector** input,
    vtkInformationVector* output
)
{
    const int done = Superclass::RequestData(request, input, output);
    vtkPolyData& data = *GetOutput();
    for
    (
        vtkCellArray* cells :
        {data.GetVerts(), data.GetLines(), data.GetStrips(), data.GetPolys()}
    )
    {
        double range[2] = {0, -1};
        if (cells->IsValid() && cells->GetNumberOfConnectivityIds() > 0)
        {
            cells->GetConnectivityArray()->GetRange(range);
        }
        if
        (
            !cells->IsValid() || range[0] < 0
         || range[1] >= double(data.GetNumberOfPoints())
        )
        {
            data.Initialize();
            vtkErrorMacro(<< "A cell has points that are not there");
            return 0;
        }
    }
    return done;
}

int VtkReader::ReadArrayValues
(
    vtkXMLDataElement* element, const vtkIdType arrayIndex,
    vtkAbstractArray* array, const vtkIdType startIndex,
    const vtkIdType numValues, const FieldType type
)
{
    const auto values = std::uint64_t(startIndex + numValues);
    const bool sound = static_cast<VtkParser*>(XMLParser)->holds
    (
        element, values*std::uint64_t(array->GetDataTypeSize())
    );
    if (!sound)
    {
        vtkErrorMacro(<< "The compressed data are broken");
        return 0;
    }
    return Superclass::ReadArrayValues
    (
        element, arrayIndex, array, startIndex, numValues, type
    );
}

} // namespace sph
