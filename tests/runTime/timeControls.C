// controlDict: what is wrong with an entry is said, with the valid choices.
#include "runTime/TestCase.H"

#include "runTime/TimeControls.H"

#include <cmath>

namespace sph
{

namespace
{

// An entry of the same key later in the file overrides
std::string errorWith(const std::string& entries)
{
    return errorOf
    (
        [&]()
        {
            const dictionary dict = dictionary::fromString
            (
                "endTime 1;\ndeltaT 1e-3;\nwriteControl timeStep;\n"
                "writeInterval 10;\n" + entries,
                "controlDict"
            );
            const TimeControls controls(dict);
        }
    );
}

} // namespace

TEST(timeControls, theListedEntriesAreAllRead)
{
    const dictionary dict = dictionary::fromString
    (
        "application granularFoamSPH; startFrom firstTime; startTime 0.5;"
        "stopAt nextWrite; endTime 2; deltaT 1e-3; adjustTimeStep on;"
        "maxCo 0.3; maxDeltaT 0.01; writeControl adjustableRunTime;"
        "writeInterval 0.05; purgeWrite 2; writeFormat ascii;"
        "writePrecision 9; writeCompression off; timeFormat scientific;"
        "timePrecision 8; runTimeModifiable no;"
    );
    const TimeControls c(dict);
    EXPECT_EQ(c.startFrom, TimeControls::StartFrom::firstTime);
    EXPECT_EQ(c.startTime, 0.5);
    EXPECT_EQ(c.stopAt, TimeControls::StopAt::nextWrite);
    EXPECT_EQ(c.endTime, 2);
    EXPECT_EQ(c.deltaT, 1e-3);
    EXPECT_TRUE(c.adjustTimeStep);
    EXPECT_EQ(c.maxCo, 0.3);
    EXPECT_EQ(c.maxDeltaT, 0.01);
    EXPECT_EQ(c.writeControl, TimeControls::WriteControl::adjustable);
    EXPECT_EQ(c.writeInterval, 0.05);
    EXPECT_EQ(c.purgeWrite, 2);
    EXPECT_TRUE(c.writeAscii);
    EXPECT_EQ(c.writePrecision, 9);
    EXPECT_FALSE(c.writeCompressed);
    EXPECT_EQ(c.timePrecision, 8);
    EXPECT_FALSE(c.runTimeModifiable);
    EXPECT_NO_THROW(dict.refuseUnused());
}

TEST(timeControls, everyWriteControlIsTheOneNamed)
{
    using Control = TimeControls::WriteControl;
    const std::vector<std::pair<const char*, Control>> controls
    {
        {"timeStep", Control::timeStep}, {"runTime", Control::runTime},
        {"adjustable", Control::adjustable},
        {"adjustableRunTime", Control::adjustable},
        {"clockTime", Control::clockTime}, {"cpuTime", Control::cpuTime}
    };
    for (const auto& [name, control] : controls)
    {
        const dictionary dict = dictionary::fromString
        (
            "endTime 1; deltaT 1; writeInterval 1; writeControl "
          + word(name) + ';'
        );
        EXPECT_EQ(TimeControls(dict).writeControl, control) << name;
    }
}

TEST(timeControls, unknownChoicesListTheValidOnes)
{
    const std::string stopAt = errorWith("stopAt endTiem;");
    EXPECT_CONTAINS(stopAt, "endTiem");
    EXPECT_CONTAINS(stopAt, "did you mean");
    for (const char* valid : {"endTime", "writeNow", "noWriteNow", "nextWrite"})
    {
        EXPECT_CONTAINS(stopAt, valid);
    }
    EXPECT_CONTAINS(stopAt, "line 5");
    EXPECT_CONTAINS(errorWith("startFrom lastTime;"), "latestTime");
    EXPECT_CONTAINS(errorWith("writeControl steps;"), "adjustable");
    EXPECT_CONTAINS(errorWith("writeFormat bin;"), "binary");
    EXPECT_CONTAINS(errorWith("timeFormat fix;"), "scientific");
    EXPECT_CONTAINS(errorWith("writeCompression gz;"), "compressed");
}

TEST(timeControls, onlyBinaryFilesAreCompressed)
{
    const std::string needed = "endTime 1; deltaT 1; writeInterval 1;";
    for (const char* on : {"on", "yes", "true", "compressed"})
    {
        const auto dict = dictionary::fromString
        (
            needed + "writeCompression " + on + ';'
        );
        EXPECT_TRUE(TimeControls(dict).writeCompressed) << on;
    }
    EXPECT_CONTAINS
    (
        errorWith("writeFormat ascii; writeCompression on;"),
        "only writeFormat binary can be compressed"
    );
}

TEST(timeControls, valuesOutOfRangeAreNamed)
{
    EXPECT_EQ(errorWith(""), "");
    for
    (
        const char* entry :
        {
            "writeInterval 0;", "writeInterval -1;", "writeInterval 2.5;",
            "deltaT 0;", "deltaT -1e-3;", "maxCo 0;", "maxCo 1.01;",
            "maxDeltaT 0;", "purgeWrite -1;", "timePrecision 0;",
            "timePrecision 18;", "writePrecision 0;"
        }
    )
    {
        const std::string error = errorWith(entry);
        const std::string key(entry, std::string(entry).find(' '));
        EXPECT_CONTAINS(error, key) << entry;
        EXPECT_CONTAINS(error, "controlDict") << entry;
        EXPECT_CONTAINS(error, "line 5") << entry;
    }
    EXPECT_EQ(errorWith("maxCo 1;"), "");
}

TEST(timeControls, endTimeIsNeededOnlyWhereTheRunStopsThere)
{
    const std::string rest = "deltaT 1; writeInterval 1;";
    EXPECT_CONTAINS
    (
        errorOf([&]() { TimeControls(dictionary::fromString(rest)); }),
        "endTime"
    );
    const TimeControls free(dictionary::fromString(rest + "stopAt nextWrite;"));
    EXPECT_TRUE(std::isinf(free.endTime));
}

TEST(timeControls, timeNamesFollowTheFormat)
{
    const auto name = [](const std::string& format, const scalar value)
    {
        const TimeControls c
        (
            dictionary::fromString
            (
                "endTime 1; deltaT 1; writeInterval 1; timeFormat "
              + format + ';'
            )
        );
        return c.timeName(value, 6);
    };
    EXPECT_EQ(name("general", 0.05), "0.05");
    EXPECT_EQ(name("general", 3*0.05), "0.15");
    EXPECT_EQ(name("general", 0), "0");
    EXPECT_EQ(name("general", 1e-5), "1e-05");
    EXPECT_EQ(name("fixed", 0.05), "0.050000");
    EXPECT_EQ(name("scientific", 0.05), "5.000000e-02");
}

} // namespace sph
