// That everything that can be read is listed, with what it means.
#include "annotation/listEntries.H"
#include "annotation/sources.H"
#include "runoutLaws/RunoutLaw.H"

#include <gtest/gtest.h>
#include <sstream>

using namespace sph;

namespace
{

// A law that says nothing of its entry
class unexplained : public RunoutLaw
{
public:
    explicit unexplained(const dictionary& dict)
    :
        RunoutLaw(dict)
    {
        dict.get<scalar>("secret");
    }

    LawValue runout(scalar) const override { return LawValue::none(""); }
    LawValue height(scalar) const override { return LawValue::none(""); }
    LawValue stopTime(scalar) const override { return LawValue::none(""); }
};

const RunoutLaw::Add<unexplained> add("unexplained", "as it says");

bool endsInCoeffs(const word& name)
{
    return name.size() > 6 && name.substr(name.size() - 6) == "Coeffs";
}

// Dictionaries may have names of the user's own
void expectMeanings(const ReadEntries& entries, const std::string& where)
{
    for (const ReadEntry& entry : entries)
    {
        const Key& key = entry.lookup.key;
        if (!entry.isDict && !endsInCoeffs(key.name))
        {
            EXPECT_NE(key.meaning, "") << key.name << " in " << where;
            EXPECT_NE(entry.value, "") << key.name << " in " << where;
        }
        expectMeanings(entry.entries, where + '.' + key.name);
    }
}

std::string listed(const word& name, const scalar spacing = 0.01)
{
    std::ostringstream os;
    listEntries(os, name, spacing);
    return os.str();
}

} // namespace

TEST(listEntries, everyEntryHasAMeaningAndAValue)
{
    Specimen specimen(0.01);
    for (const DictionarySource& source : dictionarySources(specimen))
    {
        expectMeanings(explore("", source.read), source.name);
    }
    for (const FamilySource& source : familySources(specimen))
    {
        for (const auto& [model, is] : SelectionTables::all()[source.family])
        {
            if (model == "unexplained")
            {
                continue;
            }
            expectMeanings
            (
                explore
                (
                    source.entry == "type"
                  ? model + " { type " + model + "; }"
                  : source.entry + ' ' + model + ';',
                    source.read
                ),
                source.family
            );
        }
    }
}

TEST(listEntries, everyFamilyIsListed)
{
    const wordList families = listedFamilies();
    for (const auto& [family, models] : SelectionTables::all())
    {
        EXPECT_EQ(std::count(families.begin(), families.end(), family), 1)
            << family;
    }
}

// Defaults that depend on the case have a sample in their Key
TEST(listEntries, nothingDependsOnTheParticles)
{
    wordList names = listedDictionaries();
    const wordList families = listedFamilies();
    names.insert(names.end(), families.begin(), families.end());
    for (const word& name : names)
    {
        EXPECT_EQ(listed(name, 0.01), listed(name, 0.013)) << name;
    }
}

TEST(listEntries, aModelIsListedInEveryFamilyThatHasIt)
{
    const std::string text = listed("Morris");
    EXPECT_NE(text.find("// In constant/boundary:\n"), std::string::npos);
    EXPECT_NE(text.find("    // greatest beta, Eq. 23;"), std::string::npos);
    EXPECT_NE(text.find("viscousScheme   Morris;"), std::string::npos);
    EXPECT_EQ(text.find("rheology"), std::string::npos);
}

TEST(listEntries, aModelWithoutSamplesDoesNotHideTheOthers)
{
    const std::string said = "// unexplained: Entry 'secret' not found";
    for (const char* name : {"runoutLaw", "unexplained"})
    {
        EXPECT_NE(listed(name).find(said), std::string::npos) << name;
    }
    EXPECT_NE(listed("runoutLaw").find("Mangeney2010Coeffs"), std::string::npos);
}

TEST(listEntries, anUnknownNameIsAnErrorWithAGuess)
{
    try
    {
        listed("muJ");
        FAIL();
    }
    catch (const Error& error)
    {
        const std::string text = error.what();
        EXPECT_NE(text.find("did you mean 'muI'?"), std::string::npos) << text;
        EXPECT_NE(text.find("\nsphSolution\n"), std::string::npos) << text;
    }
}
