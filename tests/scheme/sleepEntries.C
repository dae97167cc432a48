// Entries of the dictionary sleep: what they do, their limits and errors.
#include "../runTime/TestCase.H"
#include "scheme/SleepBlocks.H"

#include <gtest/gtest.h>

namespace sph
{

TEST(sleep, entriesAreTheThresholds)
{
    const auto asleepAfter = [](const std::string& entries, scalar share)
    {
        Sliding scene(share, entries);
        const scalar dt = scene.acousticStep();
        scene.run(dt, label(10*scene.tau()/dt));
        return scene.asleep() > 0;
    };
    EXPECT_TRUE(asleepAfter("speed 0.1; mean 0.1;", 0.09));
    EXPECT_FALSE(asleepAfter("speed 0.1; mean 0.08;", 0.09));
    EXPECT_FALSE(asleepAfter("speed 0.08; mean 0.1;", 0.09));
    EXPECT_FALSE(asleepAfter("speed 0.002; mean 0.1;", 0.005));
    // The mean has not forgotten the start
    EXPECT_FALSE(asleepAfter("speed 0.2; mean 0.1; period 1.5;", 0.005));
}

TEST(sleep, errorsNameFileAndEntry)
{
    const auto refused = [](const std::string& solution, const CaseText& text)
    {
        TestScene scene(text, dx);
        place(scene.particles, {{0, 0}}, CaseText::rho0);
        return errorOf
        (
            [&]
            {
                const dictionary dict =
                    dictionary::fromString(solution, "system/sphSolution");
                const dictionary none;
                const Sleep sleep
                (
                    dict, {text.g, none, none}, scene.particles,
                    scene.scheme.neighbourhood(), scene.material.eos(), 0.01
                );
                dict.refuseUnused();
            }
        );
    };
    EXPECT_EQ(refused("sleep {}", CaseText()), "");
    EXPECT_EQ(refused("", CaseText::plain()), "");
    EXPECT_EQ
    (
        refused
        (
            "sleep { speed 0.02; mean 0.01; rest 0.002; imbalance 0.08;"
            " period 0.1; damping 0.05; }",
            CaseText()
        ),
        ""
    );

    const std::string noGravity = refused("sleep {}", CaseText::plain());
    EXPECT_CONTAINS(noGravity, "Without gravity");
    EXPECT_CONTAINS(noGravity, "system/sphSolution");
    EXPECT_CONTAINS(noGravity, "sleep");

    for
    (
        const char* entry :
        {"speed", "mean", "rest", "imbalance", "period", "damping"}
    )
    {
        for (const char* value : {"-0.1", "0", "fast", "[0 1 -1 0 0 0 0] 1"})
        {
            const std::string text = refused
            (
                "\nsleep\n{\n" + std::string(entry) + ' ' + value + ";\n}\n",
                CaseText()
            );
            EXPECT_CONTAINS(text, "system/sphSolution") << value;
            EXPECT_CONTAINS(text, entry) << value;
            EXPECT_CONTAINS(text, "line 4") << value;
        }
    }

    const std::string unknown =
        refused("sleep\n{\nperiods 0.1;\n}\n", CaseText());
    EXPECT_CONTAINS(unknown, "system/sphSolution");
    EXPECT_CONTAINS(unknown, "periods");
    EXPECT_CONTAINS(unknown, "did you mean 'period'");

    for (const char* value : {"yes", "no", "", "(a b)", "0.02"})
    {
        const std::string text = refused
        (
            "skin 0.2;\nsleep " + std::string(value) + ";\n", CaseText()
        );
        EXPECT_CONTAINS
        (
            text, "Entry 'sleep' must be a dictionary: sleep { }"
        );
        EXPECT_CONTAINS(text, "system/sphSolution");
        EXPECT_CONTAINS(text, "line 2");
    }
}

// What is faster than a fifth of v flows
TEST(sleep, thresholdsHaveLimits)
{
    const auto refused = [](const std::string& entries)
    {
        return errorOf
        (
            [&]
            {
                SleepScene
                (
                    CaseText(), dx, squareLattice({0, 0}, 2, 2, dx), entries
                );
            }
        );
    };
    const std::pair<const char*, const char*> limits[]
    {
        {"speed", "0.2"}, {"mean", "0.2"}, {"imbalance", "1"}, {"period", "10"}
    };
    for (const auto& [entry, limit] : limits)
    {
        const std::string start = '\n' + std::string(entry) + ' ';
        EXPECT_EQ(refused(start + limit + ';'), "");
        const std::string error = refused(start + limit + "1;");
        EXPECT_CONTAINS(error, "greater than 0 and at most " + word(limit));
        EXPECT_CONTAINS(error, entry);
        EXPECT_CONTAINS(error, "line 2");
    }
    EXPECT_EQ(refused("damping 1000;"), "");
    EXPECT_EQ(refused("rest 0.02;"), "");
    EXPECT_EQ(refused("speed 0.2; rest 0.2;"), "");
    for (const char* entries : {"\nrest 0.03;", "\nspeed 0.001;"})
    {
        const std::string error = refused(entries);
        EXPECT_CONTAINS(error, "Entry 'rest' is ");
        EXPECT_CONTAINS(error, " but must be at most speed, ");
        EXPECT_CONTAINS(error, "line 2");
    }
}

} // namespace sph
