#include "io/VtkParser.H"

#include <array>
#include <cstring>
#include <vtkInputStream.h>
#include <vtkObjectFactory.h>
#include <vtkXMLDataElement.h>

namespace sph
{

vtkStandardNewMacro(VtkParser);

void VtkParser::StartElement(const char* name, const char** attributes)
{
    if (++depth_ <= deepest)
    {
        Superclass::StartElement(name, attributes);
    }
    tooDeep_ = tooDeep_ || depth_ > deepest;
}

void VtkParser::EndElement(const char* name)
{
    if (depth_-- <= deepest)
    {
        Superclass::EndElement(name);
    }
}

bool VtkParser::seek(vtkXMLDataElement* array)
{
    vtkTypeInt64 offset = 0;
    const char* format = array->GetAttribute("format");
    if (array->GetAttribute("offset"))
    {
        array->GetScalarAttribute("offset", offset);
        DataStream = AppendedDataStream;
        SeekG(AppendedDataPosition + offset);
    }
    else if (format && std::strcmp(format, "ascii") != 0)
    {
        DataStream = InlineDataStream;
        SeekInlineDataPosition(array);
    }
    else
    {
        return false;
    }
    DataStream->SetStream(Stream);
    return true;
}

// The head: number of blocks, bytes in each, and in the last one if that is
// shorter; then the sizes of all
bool VtkParser::holds(vtkXMLDataElement* array, const std::uint64_t bytes)
{
    if (!Compressor || !seek(array))
    {
        return true;
    }
    constexpr std::uint64_t most = std::uint64_t(1) << 40;
    const std::size_t wordSize = HeaderType/8;
    std::array<unsigned char, 24> head{};
    DataStream->StartReading();
    const std::size_t size = DataStream->Read(head.data(), 3*wordSize);
    DataStream->EndReading();
    if (size != 3*wordSize)
    {
        return false;
    }
    PerformByteSwap(head.data(), 3, wordSize);
    std::array<std::uint64_t, 3> words{};
    for (std::size_t i = 0; i < 3; ++i)
    {
        std::memcpy(&words[i], head.data() + i*wordSize, wordSize);
    }
    const auto [blocks, blockSize, lastSize] = words;
    if (blocks == 0)
    {
        return bytes == 0;
    }
    // None empty, and none longer than what is asked for
    if (blockSize == 0 || blockSize > most || lastSize > blockSize)
    {
        return false;
    }
    const std::uint64_t shorter = lastSize > 0 ? blockSize - lastSize : 0;
    return blocks <= bytes && blocks*blockSize - shorter == bytes;
}

} // namespace sph
