// Spoilt files of particles are read, or refused with an Error.
#include "fuzz/Fuzz.H"
#include "fuzz/targets.H"
#include "io/caseIO.H"
#include "io/randomState.H"
#include "runTime/TestCase.H"

namespace sph
{

// Written in every format; few particles, so that all of a file is reached
static std::vector<std::string> stateFiles()
{
    std::vector<std::string> files;
    const TestCase testCase;
    for (const label nGranular : {1, 7})
    {
        for
        (
            const WriteOptions& options :
            {WriteOptions{}, WriteOptions{false, true}, WriteOptions{true}}
        )
        {
            Particles particles;
            fillRandomly(particles, nGranular, 3);
            writeState(particles, 0.5, testCase.dir()/"0", options);
            files.push_back(testCase.text("0/granular.vtp"));
            files.push_back(testCase.text("0/walls.vtp"));
        }
    }
    return files;
}

TEST(fuzz, states)
{
    Fuzz fuzz;
    fuzz.corpus = stateFiles();
    fuzz.words =
    {
        "<", ">", "/>", "\"", "<DataArray", "</DataArray>", "<Piece",
        "</Piece>", "<PointData>", "<Points>", "<Verts>", "<FieldData>",
        "<PolyData>", "<AppendedData encoding=\"raw\">_", "</VTKFile>",
        "type=\"Float64\"", "type=\"Float32\"", "type=\"Int64\"",
        "type=\"UInt8\"", "type=\"String\"", "type=\"Bit\"", "Name=\"U\"",
        "Name=\"rho\"", "Name=\"id\"", "Name=\"patch\"", "Name=\"spacing\"",
        "NumberOfComponents=\"0\"", "NumberOfComponents=\"-1\"",
        "NumberOfComponents=\"1000000\"", "NumberOfTuples=\"1000000000\"",
        "NumberOfPoints=\"1000000000\"", "NumberOfPoints=\"-1\"",
        "NumberOfVerts=\"1000000000\"", "format=\"ascii\"",
        "format=\"binary\"", "format=\"appended\"", "offset=\"1000000\"",
        "offset=\"-1\"", "header_type=\"UInt32\"", "header_type=\"UInt64\"",
        "byte_order=\"BigEndian\"", "compressor=\"vtkZLibDataCompressor\"",
        "compressor=\"vtkLZ4DataCompressor\"", "version=\"2.0\"",
        "&amp;", "&#0;", "<!DOCTYPE a [<!ENTITY b \"bb\">]>", "&b;",
        std::string(8, '\0'), std::string(8, '\xff')
    };
    fuzz.target = [](const std::string& input, std::size_t)
    {
        readAnyState(input);
    };
    for (const std::string& file : fuzz.corpus)
    {
        EXPECT_NO_THROW(readAnyState(file));
    }
    fuzz.run("states", 1500);
}

} // namespace sph
