#include "particles/team.H"

#include "support/Threads.H"

#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>

using namespace sph;

// On any number of threads, for ranges of any size
TEST(team, partsMakeUpTheRangeOnceAndBeginAtWholeSlices)
{
    for (const label threads : {1, 2, 3})
    {
        const Threads some(threads);
        for (const label n : {0, 1, 7, 255, 256, 257, 2001, 10000})
        {
            const ParticleRange range{16, 16 + n};
            const auto visits = std::make_unique<std::atomic<int>[]>(16 + n);
            std::atomic<int> ragged{0};
            shareOut
            (
                range,
                [&](const ParticleRange& part)
                {
                    ragged += part.begin % laneCount != 0;
                    ragged += part.end < range.end && part.end % laneCount;
                    for (label i = part.begin; i < part.end; ++i)
                    {
                        ++visits[i];
                    }
                }
            );
            EXPECT_EQ(ragged, 0);
            for (label i = 0; i < range.end; ++i)
            {
                EXPECT_EQ(visits[i], i < range.begin ? 0 : 1) << i;
            }
        }
    }
}

// CTest runs as many tests as there are cores: a test that takes them all
// itself waits for the others in every loop
TEST(team, isAsLargeAsTheBuildWantsItInTests)
{
    if (!std::getenv("CTEST_INTERACTIVE_DEBUG_MODE"))
    {
        GTEST_SKIP() << "not started by CTest";
    }
    const char* threads = std::getenv("OMP_NUM_THREADS");
    ASSERT_NE(threads, nullptr);
    EXPECT_EQ(std::to_string(omp_get_max_threads()), threads);
}
