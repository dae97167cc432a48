// Files of other tools: what may differ, what may be missing, and what is
// said about wrong values.
#include "io/caseIO.H"
#include "runTime/TestCase.H"

#include <cmath>

namespace sph
{

namespace
{

struct Array
{
    std::string name;
    std::string type;
    int components;
    std::string values;
};

const Array points{"Points", "Float32", 3, "0 0 0  0.5 0 0  0.5 1 0"};
const Array U{"U", "Float32", 3, "1 2 0  3 4 0  5 6 0"};
const Array U2{"U", "Float64", 2, "1 2  3 4  5 6"};
const Array rho{"rho", "Float32", 1, "1000 1500 2000"};
const Array m{"m", "Float64", 1, "250 375 500"};
const Array V{"V", "Float64", 1, "0.25 0.5 0.125"};
const Array id{"id", "Int32", 1, "30 10 20"};

std::string element(const Array& array)
{
    return
        "<DataArray type=\"" + array.type + "\" Name=\"" + array.name
      + "\" NumberOfComponents=\"" + std::to_string(array.components)
      + "\" format=\"ascii\">" + array.values + "</DataArray>\n";
}

std::string vtp
(
    const std::vector<Array>& arrays, const std::string& fieldData = "",
    const Array& position = points
)
{
    std::string text =
        "<VTKFile type=\"PolyData\" version=\"0.1\""
        " byte_order=\"LittleEndian\">\n<PolyData>\n" + fieldData
      + "<Piece NumberOfPoints=\"3\" NumberOfVerts=\"0\" NumberOfLines=\"0\""
        " NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n";
    for (const Array& array : arrays)
    {
        text += element(array);
    }
    return
        text + "</PointData>\n<Points>\n" + element(position)
      + "</Points>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

const char* const spacing =
    "<FieldData><DataArray type=\"Float64\" Name=\"spacing\""
    " NumberOfTuples=\"1\" format=\"ascii\">0.5</DataArray></FieldData>\n";

struct ForeignFiles : testing::Test
{
    TestCase testCase;
    Particles particles;

    bool read(const std::string& text)
    {
        testCase.write("0/granular.vtp", text);
        return readState(testCase.dir()/"0", particles);
    }
    std::string error(const std::string& text)
    {
        return errorOf([&]() { read(text); });
    }
};

Array changed(Array array, const std::string& values)
{
    array.values = values;
    return array;
}

} // namespace

TEST_F(ForeignFiles, singlePrecisionWithoutIdsIsAStartButNoRestart)
{
    EXPECT_FALSE(read(vtp({U, rho, m})));
    ASSERT_EQ(particles.granular().size(), 3);
    for (label i = 0; i < 3; ++i)
    {
        EXPECT_EQ(particles.id[i], i);
        EXPECT_EQ(particles.U.x[i], 1 + 2*i);
        EXPECT_EQ(particles.U.y[i], 2 + 2*i);
        EXPECT_EQ(particles.rho[i], 1000 + 500*i);
        EXPECT_EQ(particles.s.xx[i], 0);
        EXPECT_EQ(particles.V[i], 0.25);
    }
    EXPECT_EQ(particles.r[2], vector(0.5, 1));
    EXPECT_EQ(particles.spacing(), 0.5);
}

TEST_F(ForeignFiles, stateOfAnEarlierReadIsGone)
{
    particles.resize(3, 0);
    particles.s.xx[1] = 7;
    particles.patch[1] = 2;
    read(vtp({U, rho, m}));
    EXPECT_EQ(particles.s.xx[1], 0);
    EXPECT_EQ(particles.patch[1], -1);
}

TEST_F(ForeignFiles, twoComponentsAndIdsAreTaken)
{
    read(vtp({id, U2, rho, m}));
    EXPECT_EQ(particles.U[1], vector(3, 4));
    EXPECT_EQ(particles.id[0], 30);
    EXPECT_EQ(particles.id[2], 20);
}

TEST_F(ForeignFiles, massIsDeducedFromVolumeOrSpacing)
{
    read(vtp({U, rho, V}));
    EXPECT_EQ(particles.m[0], 250);
    EXPECT_EQ(particles.m[1], 750);
    EXPECT_EQ(particles.m[2], 250);
    EXPECT_EQ(particles.spacing(), std::sqrt(0.5));

    read(vtp({U, rho}, spacing));
    EXPECT_EQ(particles.m[1], 375);
    EXPECT_EQ(particles.spacing(), 0.5);

    const std::string message = error(vtp({U, rho}));
    EXPECT_CONTAINS(message, "array m ");
    EXPECT_CONTAINS(message, "V (volume");
    EXPECT_CONTAINS(message, "spacing");
}

TEST_F(ForeignFiles, missingMandatoryArraysAreNamedWithThoseThere)
{
    const std::string message = error(vtp({rho, m}));
    EXPECT_CONTAINS(message, "FATAL IO ERROR");
    EXPECT_CONTAINS(message, "array U is missing");
    EXPECT_CONTAINS(message, "\nm\nrho\n");
    EXPECT_CONTAINS(message, "0/granular.vtp");
    EXPECT_CONTAINS(error(vtp({U, m})), "array rho is missing");
}

TEST_F(ForeignFiles, wrongNumberOfComponentsIsNamed)
{
    Array wrong = U;
    wrong.components = 1;
    wrong.values = "1 2 3";
    EXPECT_CONTAINS(error(vtp({wrong, rho, m})), "U has 1 components");
    Array stress{"s", "Float64", 3, "1 2 3 1 2 3 1 2 3"};
    EXPECT_CONTAINS
    (
        error(vtp({U, rho, m, stress})), "s has 3 components; it must have 6"
    );
}

TEST_F(ForeignFiles, unknownTypesOfArraysAreNamed)
{
    Array wrong = rho;
    wrong.type = "Real64";
    EXPECT_CONTAINS(error(vtp({U, wrong, m})), "type of array rho is unknown");

    // In the field data VTK itself would crash
    std::string fieldData = spacing;
    fieldData.replace(fieldData.find("Float64"), 7, "Real64");
    EXPECT_CONTAINS
    (
        error(vtp({U, rho, m}, fieldData)), "type of array spacing is unknown"
    );
}

TEST_F(ForeignFiles, wrongValuesNameTheParticle)
{
    EXPECT_CONTAINS
    (
        error(vtp({id, U, rho, changed(m, "250 0 500")})),
        "m must be finite and greater than 0, but is 0.000000 at particle 10"
    );
    EXPECT_CONTAINS
    (
        error(vtp({U, changed(rho, "1 1 -2"), m})), "rho must be finite and greater"
    );
    EXPECT_CONTAINS
    (
        error(vtp({U, changed(rho, "1 1 -2"), m})), "particle 2"
    );
    EXPECT_CONTAINS
    (
        error(vtp({U, changed(rho, "1 1e-30 1"), changed(m, "1 1e300 1")})),
        "V = m/rho must be finite"
    );
    const Array ids{"id", "Float64", 1, "1 2.5 3"};
    EXPECT_CONTAINS
    (
        error(vtp({ids, U, rho, m})),
        "id must hold whole numbers, but is 2.500000 at point 1"
    );
    EXPECT_CONTAINS
    (
        error(vtp({changed(ids, "1 2 1e300"), U, rho, m})), "whole numbers"
    );
    EXPECT_CONTAINS
    (
        error(vtp({id, changed(U, "1 2 0 3 4 0 nan 6 0"), rho, m})),
        "U is not finite at particle 20"
    );
    EXPECT_CONTAINS
    (
        error(vtp({U, rho, m}, "", changed(points, "0 0 0 inf 0 0 0 0 0"))),
        "position of particle 1 is not finite"
    );
    EXPECT_CONTAINS
    (
        error(vtp({U, rho, m}, "", changed(points, "0 0 0 0 0 2 0 0 0"))),
        "out of the plane"
    );
}

} // namespace sph
