// What is found out about a dictionary by reading it.
#include "annotation/Exploration.H"
#include "annotation/writeEntries.H"

#include <gtest/gtest.h>
#include <sstream>

using namespace sph;

namespace
{

// Reads most of what there is to be read
void readThing(const dictionary& dict)
{
    dict.get({"mass", "of the thing", "2.5"}, dimMass, Range::positive());
    const bool loud = dict.getOrDefault({"loud", "how it is"}, false);
    const word way = dict.getChoice({"way", "goes", "left"}, {"left", "right"});
    if (way == "right")
    {
        dict.getLabelOrDefault({"lane", "of the way"}, 2, Range::between(1, 4));
    }
    if (loud && dict.found({"echo", "comes back", "{}"}))
    {
        dict.subDict("echo").getOrDefault
        (
            {"delay", "until then"}, 0.5, dimTime, Range::nonNegative()
        );
    }
    dict.getOrDefault({"width", "as it is measured", "3"}, 7.25, dimless);
}

const ReadEntry& at(const ReadEntries& entries, const word& name)
{
    for (const ReadEntry& entry : entries)
    {
        if (entry.lookup.key.name == name)
        {
            return entry;
        }
    }
    throw std::runtime_error("no " + name);
}

std::string annotated(const DictionaryReader& read)
{
    std::ostringstream os;
    writeEntries(os, explore("", read));
    return os.str();
}

} // namespace

TEST(exploration, findsWhatOneReadingDoesNotAskFor)
{
    const ReadEntries entries = explore("", readThing);
    EXPECT_EQ(at(entries, "lane").condition, "way right");
    EXPECT_EQ(at(entries, "echo").condition, "loud yes");
    EXPECT_EQ(at(at(entries, "echo").entries, "delay").value, "0.5");
    EXPECT_TRUE(at(entries, "echo").optional);
    EXPECT_FALSE(at(entries, "mass").optional);
}

TEST(exploration, whatItWritesIsADictionaryThatCanBeRead)
{
    const std::string text = annotated(readThing);
    const auto dict = dictionary::fromString(text, "annotated");
    EXPECT_NO_THROW(readThing(dict));
    EXPECT_NO_THROW(dict.refuseUnused());
    EXPECT_EQ(dict.get("mass", dimMass), 2.5);
    EXPECT_FALSE(dict.found("lane"));
}

TEST(exploration, saysMeaningRangeChoicesDimensionsDefaultAndCondition)
{
    const std::string text = annotated(readThing);
    for
    (
        const char* part :
        {
            "// of the thing; greater than 0\n"
            "mass            [1 0 0 0 0 0 0] 2.5;\n",
            "// how it is; yes or no\nloud            no;    // default\n",
            "// goes; one of left right\nway             left;\n",
            "// of the way; whole number, from 1 to 4; with way right\n"
            "// lane            2;    // default\n",
            "// comes back; with loud yes\n// echo\n// {\n"
            "//     // until then; at least 0\n"
            "//     delay           [0 0 1 0 0 0 0] 0.5;    // default\n// }\n",
            "// as it is measured\n// width           3;\n"
        }
    )
    {
        EXPECT_NE(text.find(part), std::string::npos) << part << "in\n" << text;
    }
}

TEST(exploration, anEntryOfTwoFormsIsToldTwice)
{
    const std::string text = annotated([](const dictionary& dict)
    {
        if (dict.getOrDefault({"steps", "what counts"}, true))
        {
            dict.getLabelOrDefault({"interval", "of steps"}, 5, Range{1});
        }
        else
        {
            dict.get({"interval", "of time", "0.1"}, dimTime);
        }
        dict.getOrDefault({"last", "stands behind"}, 1, dimless);
    });
    EXPECT_NE
    (
        text.find
        (
            "interval        5;    // default\n\n"
            "// of time; with steps no\n"
            "// interval        [0 0 1 0 0 0 0] 0.1;\n\n"
            "// stands behind\n"
        ),
        std::string::npos
    ) << text;
}

TEST(exploration, anEntryWithoutSampleIsAnError)
{
    EXPECT_THROW
    (
        explore("", [](const dictionary& dict) { dict.get<scalar>("a"); }),
        IOError
    );
}
