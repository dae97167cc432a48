#include "support.H"

#include <cmath>

using namespace sph;

namespace
{

scalar value(const std::string& expression)
{
    return parse("x #eval{ " + expression + " };").get<scalar>("x");
}

void expectFault(const std::string& expression, const std::string& message)
{
    expectParseError(2, message, "a 1;\nx #eval{ " + expression + " };");
}

} // namespace

TEST(DictionaryExpressions, keepThePrecedence)
{
    EXPECT_EQ(value("1 + 2*3"), 7);
    EXPECT_EQ(value("(1 + 2)*3"), 9);
    EXPECT_EQ(value("8/4/2"), 1);
    EXPECT_EQ(value("7 - 2 - 1"), 4);
    EXPECT_EQ(value("-2*-3"), 6);
    EXPECT_EQ(value("7 % 4 + 1"), 4);
    EXPECT_EQ(value("1 + 1 == 2 && 3 > 2 || 0"), 1);
    EXPECT_EQ(value("!(1 < 2)"), 0);
    EXPECT_EQ(value("2 <= 2 && 2 >= 3"), 0);
    EXPECT_EQ(value("1 != 1"), 0);
    EXPECT_EQ(value("0 ? 1 : 0 ? 2 : 3"), 3);
    EXPECT_EQ(value("1e-3*1.5E3"), 1.5);
}

TEST(DictionaryExpressions, knowTheFunctions)
{
    EXPECT_DOUBLE_EQ(value("pi()"), pi);
    EXPECT_DOUBLE_EQ(value("degToRad(180)"), pi);
    EXPECT_DOUBLE_EQ(value("radToDeg(pi())"), 180);
    EXPECT_DOUBLE_EQ(value("sqrt(16) + cbrt(27) + sqr(3)"), 16);
    EXPECT_DOUBLE_EQ(value("pow(2, 10)"), 1024);
    EXPECT_DOUBLE_EQ(value("exp(log(5)) + log10(100)"), 7);
    EXPECT_DOUBLE_EQ(value("sin(0.5)"), std::sin(0.5));
    EXPECT_DOUBLE_EQ(value("cos(0.5)"), std::cos(0.5));
    EXPECT_DOUBLE_EQ(value("tan(0.5)"), std::tan(0.5));
    EXPECT_DOUBLE_EQ(value("asin(0.5)"), std::asin(0.5));
    EXPECT_DOUBLE_EQ(value("acos(0.5)"), std::acos(0.5));
    EXPECT_DOUBLE_EQ(value("atan(0.5)"), std::atan(0.5));
    EXPECT_DOUBLE_EQ(value("atan2(1, -1)"), std::atan2(1, -1));
    EXPECT_EQ(value("mag(-3) + abs(-4)"), 7);
    EXPECT_EQ(value("min(1, 2) + max(3, 4)"), 5);
    EXPECT_EQ(value("floor(1.7) + ceil(1.2)"), 3);
    EXPECT_EQ(value("mag(vector(3, 4, 0))"), 5);
}

TEST(DictionaryExpressions, giveVectors)
{
    const auto dict = parse("g (0 -2 0); x #eval{ 2*$g - vector(1, 0, 0) };");
    EXPECT_EQ(dict.get<vector>("x"), vector(-1, -4));
}

TEST(DictionaryExpressions, giveLabelsWhereTheNumberIsWhole)
{
    EXPECT_EQ(parse("x #eval{ 2*5 };").get<label>("x"), 10);
    EXPECT_EQ(parse("x #eval{ 1e6 };").get<label>("x"), 1000000);
    EXPECT_THROW(parse("x #eval{ 5/2 };").get<label>("x"), IOError);
}

TEST(DictionaryExpressions, seeEntriesOfEnclosingDictionaries)
{
    const auto dict = parse
    (
        "dx 2; s { t { a 3; y #eval{ ${dx}*$a + $:dx + ${none:-10} }; } }"
    );
    EXPECT_EQ(dict.valueText("s.t.y"), "18");
}

TEST(DictionaryExpressions, takeVariablesAsWholeValues)
{
    EXPECT_EQ(x("a -1; x #eval{ 2 -$a };"), "3");
    EXPECT_EQ(x("n nu [mm^2/s] 3; x #eval{ $n*1e6 };"), "3");
    EXPECT_EQ(x("s yes; x #eval{ $s ? 1 : 2 };"), "1");
    EXPECT_EQ(x("n 0; x #eval{ $n > 0 ? 1/$n : 5 };"), "5");
}

TEST(DictionaryExpressions, haveOtherForms)
{
    EXPECT_EQ(x("x #eval \"1 + 1\";"), "2");
    EXPECT_EQ(x("x #calc \"1 + 2\";"), "3");
    EXPECT_EQ(x("x #calc #{ 1 + 3 #};"), "4");
}

TEST(DictionaryExpressions, saysWhatIsWrong)
{
    expectFault("2*(1 + ", "missing at the end");
    expectFault("2*(1 + 1", "')'");
    expectFault("2 3", "unexpected '3'");
    expectFault("* 3", "before '*'");
    expectFault("", "empty");
    expectFault("sqr(1, 2)", "sqr() takes 1 argument, not 2");
    expectFault("sqroot(1)", "unknown function 'sqroot()'");
    expectFault("sqrtt(1)", "did you mean 'sqrt()'?");
    expectFault("a + 1", "write $a");
    expectFault("1/0", "not a finite number");
    expectFault("sqrt(-1)", "not a finite number");
    expectFault("$b", "'$b'");
    expectFault("1 + vector(1, 2, 3)", "cannot be added");
    expectFault("vector(1, 2, 3)*vector(1, 2, 3)", "be multiplied");
    expectFault("1/vector(1, 2, 3)", "divided by a vector");
    expectFault("vector(1, 2, 3) % 2", "% takes numbers");
    expectFault("vector(1, 2, 3) < 2", "not a vector");
    expectFault("$ + 1", "name is missing");
    expectFault(std::string(1000, '('), "nested too deeply");
}

TEST(DictionaryExpressions, saysOnWhichLine)
{
    expectParseError(4, "before ')'", "a 1;\nx #eval\n{ 1 +\n 2*) };");
    expectParseError(2, "'{' opened here", "a 1;\nx #eval{ 1 +\n 2\n");
}
