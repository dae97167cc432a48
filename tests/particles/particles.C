#include "primitives/error.H"
#include "support/Lattice.H"

#include <gtest/gtest.h>

#include <set>

namespace sph
{

// Everything 0, but for a density that may be divided by
static bool isNull(const Particles& P, const label i)
{
    scalar sum = P.r[i].norm();
    for (const FieldInfo& info : P.fields())
    {
        for (const scalarField* c : info.components)
        {
            sum += info.name == "rho" ? 0 : std::abs((*c)[i]);
        }
    }
    return sum == 0 && P.rho[i] > 0 && P.id[i] == -1 && P.patch[i] == -1;
}

static void fill(Particles& P, const ParticleRange& range, const label seed)
{
    for (label i = range.begin; i < range.end; ++i)
    {
        P.r.set(i, {seed + i, seed - i});
        P.id[i] = 1000*seed + i;
        P.patch[i] = seed;
        scalar k = seed;
        for (const FieldInfo& info : P.fields())
        {
            for (scalarField* c : info.components)
            {
                (*c)[i] = 100*(++k) + i;
            }
        }
    }
}

TEST(particles, rangesStandOneAfterAnotherAtWholeLanes)
{
    Particles P(0.1);
    P.resize(13, 5);
    P.resizeGhosts(9);
    EXPECT_EQ(P.granular().begin, 0);
    EXPECT_EQ(P.granular().size(), 13);
    EXPECT_EQ(P.walls().begin, 16);
    EXPECT_EQ(P.walls().size(), 5);
    EXPECT_EQ(P.ghosts().begin, 24);
    EXPECT_EQ(P.ghosts().size(), 9);
    EXPECT_GE(P.null(), P.ghosts().end);
    EXPECT_EQ(P.size(), P.null() + 1);
    EXPECT_EQ(P.spacing(), 0.1);
    // Lanes may be loaded from the null particle on
    EXPECT_GE(label(P.rho.size()), P.size() + laneCount - 1);
}

TEST(particles, gapsAndTheNullParticleAreNull)
{
    Particles P(0.1);
    P.resize(13, 5);
    fill(P, P.granular(), 1);
    fill(P, P.walls(), 2);
    P.resizeGhosts(9);
    fill(P, P.ghosts(), 3);
    EXPECT_TRUE(isNull(P, P.null()));
    EXPECT_FALSE(isNull(P, 12));

    P.resizeGhosts(2);
    EXPECT_TRUE(isNull(P, P.null()));
    P.resize(10, 5);
    for (label i = 10; i < 16; ++i)
    {
        EXPECT_TRUE(isNull(P, i)) << i;
    }
    EXPECT_EQ(P.walls().begin, 16);
    EXPECT_EQ(P.id[P.walls().begin], 2016);
    EXPECT_TRUE(isNull(P, P.null()));
}

TEST(particles, growingKeepsWhatIsThere)
{
    Particles P(0.1);
    P.resize(13, 5);
    fill(P, P.granular(), 1);
    P.resize(40, 7);
    EXPECT_EQ(P.id[12], 1012);
    EXPECT_EQ(P.r[12], vector(13, -11));
    for (label i = 13; i < P.size(); ++i)
    {
        EXPECT_TRUE(isNull(P, i)) << i;
    }
}

TEST(particles, growingGhostsKeepsGranularAndWalls)
{
    Particles P(0.1);
    P.resize(13, 5);
    fill(P, P.granular(), 1);
    fill(P, P.walls(), 2);
    for (label n = 1; n < 3000; n *= 2)
    {
        P.resizeGhosts(n);
        EXPECT_TRUE(isNull(P, P.null()));
        EXPECT_GE(label(P.rho.size()), P.size() + laneCount - 1);
    }
    EXPECT_EQ(P.id[12], 1012);
    EXPECT_EQ(P.id[P.walls().begin + 4], 2020);
}

TEST(particles, allAreAwakeAfterResize)
{
    Particles P(0.1);
    P.resize(45, 5);
    P.setAwake(16, 24);
    for (const label n : {45, 13, 61})
    {
        P.resize(n, 5);
        EXPECT_EQ(P.awake().end, n);
        EXPECT_EQ(P.active().end, n);
        EXPECT_EQ(P.watching().size(), 0);
        EXPECT_EQ(P.sleepers().size(), 0);
    }
}

// [awake | watching | sound asleep], whole slices of the first two
TEST(particles, sleepersStandBehindThoseThatAreAwake)
{
    Particles P(0.1);
    const label n = 45;
    P.resize(n, 5);
    for (label nAwake = 0; nAwake <= n; ++nAwake)
    {
        for (label nActive = nAwake; nActive <= n; ++nActive)
        {
            P.setAwake(nAwake, nActive);
            EXPECT_EQ(P.awake().begin, 0);
            EXPECT_EQ(P.active().begin, 0);
            EXPECT_EQ(P.watching().begin, P.awake().end);
            EXPECT_EQ(P.watching().end, P.active().end);
            EXPECT_EQ(P.sleepers().begin, P.awake().end);
            EXPECT_EQ(P.sleepers().end, n);
            for
            (
                const auto& [end, least] :
                {
                    std::pair{P.awake().end, nAwake},
                    std::pair{P.active().end, nActive}
                }
            )
            {
                EXPECT_TRUE(end % laneCount == 0 || end == n);
                EXPECT_GE(end, least);
                EXPECT_LT(end, least + laneCount);
            }
        }
    }
    EXPECT_EQ(P.granular().size(), n);
    EXPECT_EQ(P.walls().begin, 48);
}

// A particle's whole state moves with its identity
TEST(particles, sortingMovesStateWithIdentity)
{
    Particles P(0.1);
    const label n = 21;
    P.resize(n, 3);
    fill(P, P.granular(), 1);
    fill(P, P.walls(), 2);
    std::vector<std::pair<std::int64_t, std::vector<scalar>>> before;
    const auto state = [&](const label i)
    {
        std::vector<scalar> values{P.r.x[i], P.r.y[i]};
        for (const FieldInfo& info : P.fields())
        {
            for (const scalarField* c : info.components)
            {
                if (info.state)
                {
                    values.push_back((*c)[i]);
                }
            }
        }
        return values;
    };
    labelField order(n);
    for (label i = 0; i < n; ++i)
    {
        before.emplace_back(P.id[i], state(i));
        order[i] = (8*i + 3) % n;
    }
    P.reorderGranular(order);
    for (label i = 0; i < n; ++i)
    {
        EXPECT_EQ(P.id[i], before[order[i]].first);
        EXPECT_EQ(state(i), before[order[i]].second);
    }
    EXPECT_EQ(P.id[P.walls().begin], 2000 + P.walls().begin);
}

TEST(particles, everythingThatARestartNeedsIsState)
{
    const Particles P;
    std::set<std::string> state;
    for (const FieldInfo& info : P.fields())
    {
        if (info.state)
        {
            state.insert(info.name);
        }
    }
    for
    (
        const char* name :
        {
            "U", "rho", "m", "s", "a", "Us", "rhoDot", "eta", "asleep", "Umean"
        }
    )
    {
        EXPECT_EQ(state.count(name), 1u) << name;
    }
}

TEST(particles, fieldsOfSleepAreUsedOnRequest)
{
    Particles P;
    EXPECT_FALSE(P.field("asleep").used);
    EXPECT_FALSE(P.field("Umean").used);
    EXPECT_TRUE(P.field("U").used);
    P.use("asleep");
    EXPECT_TRUE(P.field("asleep").used);
    EXPECT_FALSE(P.field("Umean").used);
}

TEST(particles, fieldsAreFoundByName)
{
    Particles P;
    EXPECT_EQ(P.field("rho").components.at(0), &P.rho);
    EXPECT_EQ(P.field("gradU").components.size(), 4u);
    EXPECT_EQ(P.field("gradU").components[2], &P.gradU.yx);
    EXPECT_EQ(P.field("s").components[1], &P.s.xy);
    try
    {
        P.field("density");
        FAIL() << "no error";
    }
    catch (const Error& error)
    {
        const std::string text = error.block();
        EXPECT_NE(text.find("density"), std::string::npos);
        EXPECT_NE(text.find("gammaDot"), std::string::npos);
    }
}

} // namespace sph
