// What is written is read again bit for bit, in every format.
#include "io/caseIO.H"
#include "io/randomState.H"
#include "runTime/TestCase.H"

#include <cmath>
#include <cstring>
#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

namespace sph
{

namespace
{

bool sameBits
(
    const scalarField& a, const scalarField& b, const ParticleRange range
)
{
    return std::memcmp
    (
        &a[range.begin], &b[range.begin], range.size()*sizeof(scalar)
    ) == 0;
}

bool isWritten(const FieldInfo& info, const bool wall)
{
    const std::string& n = info.name;
    if (wall)
    {
        return n == "U" || n == "p" || n == "rho" || n == "m" || n == "s";
    }
    return
        (info.state && info.used) || n == "p" || n == "gammaDot" || n == "I"
     || n == "lambda" || n == "div" || n == "V";
}

void expectSameRange
(
    const Particles& written, const Particles& read,
    const ParticleRange range, const bool wall
)
{
    EXPECT_TRUE(sameBits(written.r.x, read.r.x, range));
    EXPECT_TRUE(sameBits(written.r.y, read.r.y, range));
    for (const FieldInfo& info : written.fields())
    {
        if (isWritten(info, wall))
        {
            const FieldInfo& other = read.field(info.name);
            for (std::size_t c = 0; c < info.components.size(); ++c)
            {
                EXPECT_TRUE
                (
                    sameBits(*info.components[c], *other.components[c], range)
                ) << info.name << " component " << c;
            }
        }
    }
    for (label i = range.begin; i < range.end; ++i)
    {
        ASSERT_EQ(written.id[i], read.id[i]);
        ASSERT_EQ(written.patch[i], read.patch[i]);
    }
    if (wall)
    {
        EXPECT_TRUE(sameBits(written.n.x, read.n.x, range));
        EXPECT_TRUE(sameBits(written.n.y, read.n.y, range));
    }
}

void expectRoundTrip(const WriteOptions& options, const std::string& format)
{
    const TestCase testCase;
    Particles written;
    fillRandomly(written, 1003, 77);
    writeState(written, 0.05, testCase.dir()/"0.05", options);
    EXPECT_CONTAINS(testCase.text("0.05/granular.vtp"), format);

    Particles read;
    read.resize(5, 5);
    EXPECT_TRUE(readState(testCase.dir()/"0.05", read));
    ASSERT_EQ(read.granular().size(), 1003);
    ASSERT_EQ(read.walls().size(), 77);
    EXPECT_EQ(read.spacing(), written.spacing());
    expectSameRange(written, read, written.granular(), false);
    expectSameRange(written, read, written.walls(), true);
    for (label i = 1003; i < read.walls().begin; ++i)
    {
        EXPECT_EQ(read.m[i], 0) << "gap";
    }

    // No temporary file stays
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(testCase.dir()/"0.05"))
    {
        EXPECT_NE(entry.path().filename().string()[0], '.');
        ++files;
    }
    EXPECT_EQ(files, 2);
}

vtkSmartPointer<vtkPolyData> load(const std::filesystem::path& file)
{
    auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
}

} // namespace

// Fields of sleep are there where they are used, and missed only there
TEST(roundTrip, fieldsThatAreNotUsedAreNotWritten)
{
    const TestCase testCase;
    Particles plain, sleeping;
    fillRandomly(plain, 10, 0);
    fillRandomly(sleeping, 10, 0);
    sleeping.use("Umean");
    writeState(plain, 0, testCase.dir()/"0", {});
    writeState(sleeping, 1, testCase.dir()/"1", {});
    EXPECT_FALSE(contains(testCase.text("0/granular.vtp"), "Umean"));

    Particles read;
    EXPECT_TRUE(readState(testCase.dir()/"0", read));
    EXPECT_EQ(read.Umean[3], vector(0, 0));
    EXPECT_TRUE(readState(testCase.dir()/"1", read));
    EXPECT_EQ(read.Umean[3], sleeping.Umean[3]);
    EXPECT_TRUE(readState(testCase.dir()/"1", sleeping));
    EXPECT_FALSE(readState(testCase.dir()/"0", sleeping));
}

TEST(roundTrip, binary)
{
    expectRoundTrip({}, "encoding=\"raw\"");
}

TEST(roundTrip, compressed)
{
    WriteOptions options;
    options.compress = true;
    expectRoundTrip(options, "vtkZLibDataCompressor");
}

TEST(roundTrip, ascii)
{
    WriteOptions options;
    options.ascii = true;
    expectRoundTrip(options, "format=\"ascii\"");
}

TEST(roundTrip, asciiWithFewDigitsIsRounded)
{
    const TestCase testCase;
    Particles written, read;
    fillRandomly(written, 10, 0);
    WriteOptions options;
    options.ascii = true;
    options.precision = 4;
    writeState(written, 0, testCase.dir()/"0", options);
    readState(testCase.dir()/"0", read);
    for (label i = 0; i < 10; ++i)
    {
        EXPECT_NE(read.U.x[i], written.U.x[i]);
        EXPECT_NEAR(read.U.x[i]/written.U.x[i], 1, 5.1e-4);
    }
}

TEST(roundTrip, whatParaViewReads)
{
    const TestCase testCase;
    Particles particles;
    fillRandomly(particles, 20, 4);
    writeState(particles, 0.25, testCase.dir()/"0.25", {});

    const auto data = load(testCase.dir()/"0.25"/"granular.vtp");
    EXPECT_EQ(data->GetNumberOfPoints(), 20);
    EXPECT_EQ(data->GetNumberOfVerts(), 20);
    EXPECT_EQ(data->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), 0.25);
    vtkPointData& arrays = *data->GetPointData();
    for (const char* name : {"U", "a", "Us"})
    {
        EXPECT_EQ(arrays.GetArray(name)->GetNumberOfComponents(), 3) << name;
    }
    EXPECT_CONTAINS
    (
        testCase.text("0.25/granular.vtp"), "type=\"Int64\" Name=\"id\""
    );

    const std::vector<std::string> names{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
    for (const char* name : {"sigma", "s"})
    {
        ASSERT_EQ(arrays.GetArray(name)->GetNumberOfComponents(), 6);
        for (int c = 0; c < 6; ++c)
        {
            EXPECT_EQ(arrays.GetArray(name)->GetComponentName(c), names[c]);
        }
    }
    vtkDataArray& sigma = *arrays.GetArray("sigma");
    for (label i = 0; i < 20; ++i)
    {
        const Particles& p = particles;
        EXPECT_EQ(sigma.GetComponent(i, 0), p.s.xx[i] - p.p[i]);
        EXPECT_EQ(sigma.GetComponent(i, 1), p.s.yy[i] - p.p[i]);
        EXPECT_EQ(sigma.GetComponent(i, 2), -p.p[i]);
        EXPECT_EQ(sigma.GetComponent(i, 3), p.s.xy[i]);
        EXPECT_EQ(sigma.GetComponent(i, 4), 0);
    }

    const auto walls = load(testCase.dir()/"0.25"/"walls.vtp");
    for (const char* name : {"id", "patch", "n", "U", "p", "rho", "m", "s", "sigma"})
    {
        EXPECT_TRUE(walls->GetPointData()->HasArray(name)) << name;
    }
}

TEST(roundTrip, withoutWallsThereIsNoWallFile)
{
    const TestCase testCase;
    Particles particles;
    fillRandomly(particles, 20, 4);
    writeState(particles, 0, testCase.dir()/"0", {});
    fillRandomly(particles, 20, 0);
    writeState(particles, 0, testCase.dir()/"0", {});
    EXPECT_FALSE(testCase.has("0/walls.vtp"));
    readState(testCase.dir()/"0", particles);
    EXPECT_EQ(particles.walls().size(), 0);
}

} // namespace sph
