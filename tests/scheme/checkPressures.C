#include "scheme/SoundSpeedColumn.H"
#include "scheme/changeBulkModulus.H"

#include <gtest/gtest.h>

namespace sph
{

using namespace soundSpeedColumn;

// Pressures of rho0 are 0 but for its rounding, in a state and by its densities
TEST(checkPressures, takesRoundingForWhatItIs)
{
    Column column("KFactor 100; H 0.1;");
    Particles& P = column.particles;
    const EquationOfState& eos = column.material.eos();
    for (label i = 0; i < P.granular().end; ++i)
    {
        P.rho[i] = rho0;
        P.p[i] = i % 2 == 0 ? 1e-16*eos.K() : 0;
    }
    EXPECT_NO_THROW(checkPressures(eos, P, 1e-16*eos.K()));
    P.p[3] = 1e-3*eos.K();
    EXPECT_THROW(checkPressures(eos, P, P.p[3]), Error);
}

} // namespace sph
