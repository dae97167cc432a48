#include "../runTime/TestCase.H"
#include "scheme/SoundSpeedColumn.H"

#include <gtest/gtest.h>

namespace sph
{

using namespace soundSpeedColumn;

TEST(soundSpeedRestart, densitiesOfATimeBelongToItsK)
{
    const TestCase dir;
    Column stiff("adaptive yes; KFactor 100; H 0.4;");
    stiff.soundSpeed.write(dir.dir()/"1");

    // One that follows takes K over, one that does not keeps the pressure
    Column follows("adaptive yes; KFactor 100; H 0.1;");
    Column constant("KFactor 100; H 0.1;");
    for (Column* column : {&follows, &constant})
    {
        const Quiet quiet;
        column->particles.rho = stiff.particles.rho;
        column->soundSpeed.read(dir.dir()/"1");
        for (label i = 0; i < nx*ny; ++i)
        {
            EXPECT_NEAR(column->pressure(i), stiff.particles.p[i], 1e-8);
        }
    }
    EXPECT_EQ(follows.K(), stiff.K());
    EXPECT_EQ(follows.particles.rho, stiff.particles.rho);
    EXPECT_EQ(constant.K(), constant.K0);

    const scalarField rho = constant.particles.rho;
    constant.soundSpeed.write(dir.dir()/"2");
    constant.soundSpeed.read(dir.dir()/"2");
    constant.soundSpeed.read(dir.dir()/"none");
    EXPECT_EQ(constant.particles.rho, rho);
}

} // namespace sph
