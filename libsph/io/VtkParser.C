#include "io/VtkParser.H"

#include <algorithm>
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

std::vector<std::uint64_t> VtkParser::readWords(const std::size_t count)
{
    const std::size_t wordSize = HeaderType/8;
    std::vector<unsigned char> bytes(count*wordSize);
    if (DataStream->Read(bytes.data(), bytes.size()) != bytes.size())
    {
        return {};
    }
    PerformByteSwap(bytes.data(), count, wordSize);
    std::vector<std::uint64_t> words(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        std::memcpy(&words[i], bytes.data() + i*wordSize, wordSize);
    }
    return words;
}

// The head: number of blocks, bytes in each, and in the last one if that is
// shorter; then the sizes of all, compressed
bool VtkParser::holds(vtkXMLDataElement* array, const std::uint64_t bytes)
{
    if (!Compressor || !seek(array))
    {
        return true;
    }
    constexpr std::uint64_t most = std::uint64_t(1) << 40;
    DataStream->StartReading();
    const auto head = readWords(3);
    const std::uint64_t blocks = head.empty() ? 0 : head[0];
    const bool stands = blocks <= fileSize_/(HeaderType/8);
    const auto sizes =
        stands ? readWords(blocks) : std::vector<std::uint64_t>();
    DataStream->EndReading();
    if (head.empty() || sizes.size() != blocks)
    {
        return false;
    }
    if (blocks == 0)
    {
        return bytes == 0;
    }
    // None empty, and none longer than what is asked for
    const std::uint64_t blockSize = head[1], lastSize = head[2];
    if (blockSize == 0 || blockSize > most || lastSize > blockSize)
    {
        return false;
    }
    const std::uint64_t shorter = lastSize > 0 ? blockSize - lastSize : 0;
    return
        blocks <= bytes && blocks*blockSize - shorter == bytes
     && *std::max_element(sizes.begin(), sizes.end()) <= fileSize_;
}

} // namespace sph
