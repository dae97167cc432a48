// Field values given as expressions of position.
#include "Filled.H"
#include "setup/createParticles.H"
#include "setup/setFieldValues.H"

#include <cmath>

using namespace sph;

namespace
{

// One unit box with these fields; entries in front of the list of regions
struct Field
{
    Filled filled;
    Particles particles{0.1};

    explicit Field
    (
        const std::string& fields, const std::string& entries = "",
        const std::string& inRegion = ""
    )
    :
        filled
        (
            entries + "\nregions (a { type box; min (0 0 0); max (1 1 0);\n"
          + inRegion + " fields {\n" + fields + " } });"
        )
    {
        createParticles
        (
            filled.regions, Boundaries(dictionary(), 0.1), 1600, particles
        );
        setFieldValues(filled.dict, filled.regions, particles);
    }

    // Calls check(i, x, y) for every particle
    template<class Check>
    void each(const Check& check) const
    {
        ASSERT_EQ(particles.granular().size(), 100);
        for (label i = 0; i < 100; ++i)
        {
            check(i, particles.r.x[i], particles.r.y[i]);
        }
    }
};

} // namespace


TEST(FieldExpressions, followThePosition)
{
    const Field field
    (
        "U { type expression; x \"2*(1 - pow(1 - y, 1.5))\"; y \"-x*y\"; }"
        "rho { type expression; value #{ 1500*exp(-y) #}; }"
        "s { type expression; xx 7; xy \"y > 0.5 ? x : 0\"; }"
    );
    field.each([&](const label i, const scalar x, const scalar y)
    {
        const Particles& P = field.particles;
        EXPECT_DOUBLE_EQ(P.U.x[i], 2*(1 - std::pow(1 - y, 1.5)));
        EXPECT_DOUBLE_EQ(P.U.y[i], -x*y);
        EXPECT_DOUBLE_EQ(P.rho[i], 1500*std::exp(-y));
        EXPECT_DOUBLE_EQ(P.s.xx[i], 7);
        EXPECT_DOUBLE_EQ(P.s.xy[i], y > 0.5 ? x : 0);
        EXPECT_DOUBLE_EQ(P.s.yy[i], -7);
    });
}

TEST(FieldExpressions, macrosAreThoseAround)
{
    // The innermost wins; units are scaled; later entries are seen too
    const Field field
    (
        "U { type expression; b 3; x \"$a*$b*y + ${c}*x\"; y \"$m.d\"; }",
        "a 5; b 100; m { d 0.25; }", "b 50; c [mm] 2;"
    );
    field.each([&](const label i, const scalar x, const scalar y)
    {
        EXPECT_NEAR(field.particles.U.x[i], 15*y + 0.002*x, 1e-14);
        EXPECT_DOUBLE_EQ(field.particles.U.y[i], 0.25);
    });
}

TEST(FieldExpressions, whatTheyNameIsUsed)
{
    const Field named
    (
        "U { type expression; x \"$a*y\"; y \"$m.d\"; }",
        "a 5; m { d 0.25; e 3; }"
    );
    EXPECT_NO_THROW(named.filled.dict.refuseUnused());
    const Field unnamed
    (
        "U { type expression; x \"y\"; y 0; }", "\na 5;"
    );
    expectError([&]{ unnamed.filled.dict.refuseUnused(); }, {"'a'"}, 3);
}

TEST(FieldExpressions, wrongOnesAreRefused)
{
    const auto set = [](const std::string& fields)
    {
        return [=]{ Field(fields).filled.dict.refuseUnused(); };
    };
    const std::string begin = "U { type expression; x ";
    expectError
    (
        set(begin + "\"$spacng\"; y 0; }"),
        {"undefined macro '$spacng'", "did you mean '$spacing'"}, 5
    );
    expectError
    (
        set(begin + "\"z\"; y 0; }"), {"unknown name 'z'", "entry 'x'"}, 5
    );
    expectError
    (
        set(begin + "\"sqrt(0.5 - y)\"; y 0; }"),
        {"not a finite number", "0.55 0)"}, 5
    );
    expectError
    (
        set(begin + "\"vector(1, 2, 3)\"; y 0; }"), {"not a vector"}, 5
    );
    expectError(set(begin + "\"x\"; }"), {"'y' not found"}, 5);
    expectError(set(begin + "(1 0 0); y 0; }"), {"in quotes"}, 5);
    expectError(set("U { type expresion; x 0; y 0; }"), {"expression"}, 5);
    expectError(set(begin + "0; y 0; z 0; }"), {"'z'", "not used"}, 5);
    expectError
    (
        set("rho { type expression; value \"y - 0.5\"; }"),
        {"greater than 0"}, 5
    );
}
