#include "scheme/Scheme.H"
#include "support/Scene.H"

#include <gtest/gtest.h>

namespace sph
{

// The paper's set of choices, taken as a case does: complete, every entry is
// read, and what stands after it overrides
namespace
{

std::string etc(const std::string& file)
{
    return "#includeEtc \"caseDicts/paperAsWritten/" + file + "\"\n";
}

void make(const std::string& schemes, const std::string& solution)
{
    const Quiet quiet;
    const dictionary properties = dictionary::fromString
    (
        etc("granularProperties")
      + "rho0 1612; linearCoeffs { H 0.1; }"
        "muICoeffs { mus 0.6; mu2 1.2; I0 2.65; d 3e-4; rhos 2600; }"
    );
    const dictionary boundary = dictionary::fromString
    (
        "bed {\n" + etc("wall") + "points ((0 0 0) (1 0 0)); }"
    );
    const dictionary schemesDict =
        dictionary::fromString(etc("sphSchemes") + schemes);
    const dictionary solutionDict =
        dictionary::fromString(etc("sphSolution") + solution);

    Particles P(0.01);
    Material material(properties, {0, -9.81}, 0.01);
    const Boundaries boundaries(boundary, 0.01);
    Scheme scheme
    (
        schemesDict, solutionDict, P, boundaries, material, {0, -9.81}
    );
    Integrator::New(solutionDict, "integrator");
    solutionDict.markUsed("viscousNumber");
    EXPECT_NEAR(material.eos().K(), 50*1612*9.81*0.1, 1e-6);
    for
    (
        const dictionary* dict :
        {&properties, &boundary, &schemesDict, &solutionDict}
    )
    {
        EXPECT_NO_THROW(dict->refuseUnused());
    }
}

} // namespace

TEST(paperAsWritten, isACompleteSet)
{
    make("", "");
}

TEST(paperAsWritten, isOverriddenByWhatFollows)
{
    make("viscousScheme Cleary;", "viscousIntegration implicit;");
    EXPECT_THROW(make("", "viscousIntegration implicit;"), IOError);
}

} // namespace sph
