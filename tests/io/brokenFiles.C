// Missing, truncated and garbled files are clear errors, without a word of
// VTK on stderr; a file that cannot be written is named with the reason.
#include "io/caseIO.H"
#include "io/randomState.H"
#include "primitives/writeFile.H"
#include "runTime/TestCase.H"

#include <csignal>
#include <cstring>
#include <ostream>
#include <random>
#include <regex>
#include <sys/resource.h>

namespace sph
{

namespace
{

const char* const formats[] = {"binary", "compressed", "ascii"};

WriteOptions optionsOf(const std::string& format)
{
    WriteOptions options;
    options.ascii = format == "ascii";
    options.compress = format == "compressed";
    return options;
}

// The file of a good state, and what reading a spoilt one of it gives
struct BrokenFiles : testing::Test
{
    TestCase testCase;

    std::string good(const std::string& format)
    {
        Particles particles;
        fillRandomly(particles, 30, 0);
        writeState(particles, 0, testCase.dir()/"0", optionsOf(format));
        return testCase.text("0/granular.vtp");
    }
    std::string errorOfReading(const std::string& text)
    {
        testCase.write("0/granular.vtp", text);
        testing::internal::CaptureStderr();
        const std::string error = errorOf
        (
            [&]()
            {
                Particles particles;
                readState(testCase.dir()/"0", particles);
            }
        );
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
        return error;
    }
};

} // namespace

TEST_F(BrokenFiles, missingFileSaysToRunSetParticles)
{
    Particles particles;
    const std::string error = errorOf
    (
        [&]() { readState(testCase.dir()/"0", particles); }
    );
    EXPECT_CONTAINS(error, "0/granular.vtp");
    EXPECT_CONTAINS(error, "setParticles");
}

TEST_F(BrokenFiles, fileWithoutParticles)
{
    Particles particles;
    writeState(particles, 0, testCase.dir()/"0", {});
    EXPECT_CONTAINS
    (
        errorOf([&]() { readState(testCase.dir()/"0", particles); }),
        "no particles"
    );
}

TEST_F(BrokenFiles, truncationAnywhereIsAnError)
{
    for (const char* format : formats)
    {
        const std::string text = good(format);
        ASSERT_EQ(errorOfReading(text), "") << format;
        for (std::size_t part = 0; part <= 60; ++part)
        {
            const std::size_t length = part*(text.size() - 2)/60;
            EXPECT_CONTAINS
            (
                errorOfReading(text.substr(0, length)), "0/granular.vtp"
            ) << format << " cut at " << length << " of " << text.size();
        }
    }
}

TEST_F(BrokenFiles, garbageIsAnError)
{
    for
    (
        const char* text :
        {
            "", "hello", "<VTKFile", "<a></a>", "\x7f" "ELF\x01\x02",
            "<VTKFile type=\"UnstructuredGrid\"></VTKFile>"
        }
    )
    {
        EXPECT_CONTAINS(errorOfReading(text), "FATAL IO ERROR") << text;
    }
}

// What VTK would not survive, or take all memory for
TEST_F(BrokenFiles, impossibleSizesAreErrors)
{
    const auto changed = [&](const char* format, auto from, const std::string& to)
    {
        return std::regex_replace
        (
            good(format), std::regex(from), to,
            std::regex_constants::format_first_only
        );
    };
    for (const char* format : formats)
    {
        EXPECT_CONTAINS
        (
            errorOfReading
            (
                changed(format, "Points=\"30\"", "Points=\"900000000\"")
            ),
            "The file is too short for its sizes"
        ) << format;
        EXPECT_CONTAINS
        (
            errorOfReading
            (
                changed(format, "Components=\"3\"", "Components=\"90000000\"")
            ),
            "The sizes of array U are wrong"
        ) << format;
    }
    const std::string depth(200000, '<');
    EXPECT_CONTAINS
    (
        errorOfReading(std::regex_replace(depth, std::regex("<"), "<a>")),
        "The file is broken"
    );
}

// Number of blocks, their size, and that of the last one; here there is but one
TEST_F(BrokenFiles, brokenBlocksAreErrors)
{
    const std::string text = good("compressed");
    const std::size_t head = text.find("encoding=\"raw\"");
    const std::size_t blocks = text.find('_', head) + 1;
    for (const std::size_t word : {0, 1, 2})
    {
        for (const std::uint64_t wrong : {0ull, 3ull, 1ull << 33, ~0ull})
        {
            std::string spoilt = text;
            const std::size_t at = blocks + 8*word;
            const bool same =
                std::memcmp(spoilt.data() + at, &wrong, sizeof(wrong)) == 0;
            std::memcpy(spoilt.data() + at, &wrong, sizeof(wrong));
            const std::string error = errorOfReading(spoilt);
            if (!same && (word != 1 || wrong == 0))
            {
                EXPECT_CONTAINS(error, "The compressed data are broken");
            }
        }
    }
}

TEST_F(BrokenFiles, spoiltBytesNeverCrash)
{
    std::mt19937 engine(1);
    for (const char* format : formats)
    {
        const std::string text = good(format);
        for (int trial = 0; trial < 100; ++trial)
        {
            std::string spoilt = text;
            for (int i = 0; i < 5; ++i)
            {
                spoilt[engine() % text.size()] = char(engine());
            }
            errorOfReading(spoilt);
        }
    }
}

TEST_F(BrokenFiles, unwritableFolderNamesPathAndReason)
{
    testCase.write("file", "");
    Particles particles;
    fillRandomly(particles, 3, 0);
    const std::string error = errorOf
    (
        [&]() { writeState(particles, 0, testCase.dir()/"file"/"0", {}); }
    );
    EXPECT_CONTAINS(error, "Cannot write");
    EXPECT_CONTAINS(error, "file/0/granular.vtp");
    EXPECT_CONTAINS(error, "Not a directory");
}

TEST_F(BrokenFiles, aFailedWriteKeepsTheOldFileAndNoTemporary)
{
    testCase.write("out/file", "old");
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{}, small{};
    getrlimit(RLIMIT_FSIZE, &limit);
    small = limit;
    small.rlim_cur = 1000;
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string error = errorOf
    (
        [&]()
        {
            writeFile
            (
                testCase.dir()/"out"/"file",
                [](std::ostream& os) { os << std::string(100000, 'x'); }
            );
        }
    );
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, before);

    EXPECT_CONTAINS(error, "out/file: File too large");
    EXPECT_EQ(testCase.text("out/file"), "old");
    EXPECT_EQ
    (
        std::distance
        (
            std::filesystem::directory_iterator(testCase.dir()/"out"),
            std::filesystem::directory_iterator()
        ),
        1
    );
}

TEST_F(BrokenFiles, anExceptionWhileWritingKeepsTheOldFile)
{
    testCase.write("out/file", "old");
    EXPECT_THROW
    (
        writeFile
        (
            testCase.dir()/"out"/"file",
            [](std::ostream& os) { os << "half"; throw Error("no more"); }
        ),
        Error
    );
    EXPECT_EQ(testCase.text("out/file"), "old");
}

TEST_F(BrokenFiles, aFileAppearsOnlyWhenItIsComplete)
{
    const std::filesystem::path file = testCase.dir()/"new"/"file";
    writeFile
    (
        file,
        [&](std::ostream& os)
        {
            os << "whole" << std::flush;
            EXPECT_FALSE(std::filesystem::exists(file));
        }
    );
    EXPECT_EQ(testCase.text("new/file"), "whole");
}

} // namespace sph
