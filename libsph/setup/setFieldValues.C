#include "setup/setFieldValues.H"

#include "setup/FieldExpression.H"
#include "setup/createParticles.H"

namespace sph
{

namespace
{

// Where a field is given, and for whom
struct Target
{
    const dictionary& top;
    const dictionary& region;
    const dictionary& fields;
    ParticleRange range;
    Particles& particles;

    // Whether the field has a dictionary, of type expression, for its value
    bool isExpression(const word& field) const
    {
        if (!fields.isDict(field))
        {
            return false;
        }
        fields.subDict(field).getChoice
        (
            {"type", "a value that depends on x and y"}, {"expression"}
        );
        return true;
    }

    FieldExpression expression(const word& field, const Key& key) const
    {
        return {fields.subDict(field), key, {&top, &region, &fields}};
    }

    // The value at its position for every particle
    template<class Value, class Set>
    void forEach(Value&& value, const Set& set) const
    {
        for (label i = range.begin; i < range.end; ++i)
        {
            set(i, value(particles.r[i]));
        }
    }
};

void setU(const Target& target)
{
    const auto set = [&](const label i, const vector& U)
    {
        target.particles.U.set(i, U);
    };
    if (!target.isExpression("U"))
    {
        const vector U = target.fields.getVector
        (
            {"U", "velocity"}, dimVelocity
        );
        target.forEach([&](const vector&) { return U; }, set);
        return;
    }
    FieldExpression x = target.expression("U", {"x", "component in x"});
    FieldExpression y = target.expression("U", {"y", "component in y"});
    target.forEach([&](const vector& r) { return vector(x(r), y(r)); }, set);
}

void setRho(const Target& target)
{
    const auto set = [&](const label i, const scalar rho)
    {
        target.particles.rho[i] = rho;
    };
    if (!target.isExpression("rho"))
    {
        const scalar rho =
            target.fields.get
            (
                {"rho", "density; beats hydrostatic"},
                dimDensity, Range::positive()
            );
        target.forEach([&](const vector&) { return rho; }, set);
        return;
    }
    FieldExpression value = target.expression
    (
        "rho", {"value", "density"}
    );
    const auto positive = [&](const vector& r)
    {
        const scalar rho = value(r);
        if (!(rho > 0))
        {
            target.fields.subDict("rho").fail
            (
                "value", "The density must be greater than 0, but is "
              + std::to_string(rho) + " at (" + std::to_string(r.x()) + ' '
              + std::to_string(r.y()) + " 0)"
            );
        }
        return rho;
    };
    target.forEach(positive, set);
}

tensor readS(const dictionary& fields)
{
    const auto s = fields.get<std::vector<scalar>>
    (
        {"s", "deviatoric stress xx xy xz yy yz zz [Pa]"}
    );
    if (s.size() != 6 || s[2] != 0 || s[4] != 0 || s[5] != 0)
    {
        fields.fail
        (
            "s", "A symmetric tensor of the plane has the six components"
            " (xx xy 0 yy 0 0)"
        );
    }
    return (tensor() << s[0], s[1], s[1], s[3]).finished();
}

void setS(const Target& target)
{
    const auto set = [&](const label i, const tensor& s)
    {
        target.particles.s.set(i, s);
    };
    if (!target.isExpression("s"))
    {
        const tensor s = readS(target.fields);
        target.forEach([&](const vector&) { return s; }, set);
        return;
    }
    FieldExpression xx = target.expression
    (
        "s", {"xx", "deviatoric stress xx = -yy [Pa]"}
    );
    FieldExpression xy = target.expression
    (
        "s", {"xy", "deviatoric stress xy [Pa]"}
    );
    const auto deviator = [&](const vector& r)
    {
        const scalar sxx = xx(r), sxy = xy(r);
        return (tensor() << sxx, sxy, sxy, -sxx).finished();
    };
    target.forEach(deviator, set);
}

using Setter = void (*)(const Target&);

const std::map<word, Setter> setters
{
    {"U", setU}, {"rho", setRho}, {"s", setS}
};

[[noreturn]] void failUnknown(const dictionary& fields, const word& name)
{
    wordList valid;
    for (const auto& [field, setter] : setters)
    {
        valid.push_back(field);
    }
    fields.fail
    (
        name, "Unknown field " + name + "\n\nValid fields :\n\n"
      + listOfWords(valid)
    );
}

} // namespace


void setFieldValues
(
    const dictionary& dict, const std::vector<RegionParticles>& regions,
    Particles& particles
)
{
    const std::vector<ParticleRange> ranges = rangesOf(regions);
    for (std::size_t k = 0; k < regions.size(); ++k)
    {
        const dictionary& region = *regions[k].dict;
        const dictionary& fields = region.subOrEmptyDict
        ({
            "fields", "values of its particles, or expressions of x and y",
            "{ U { type expression; x \"0.1*y\"; y 0; } rho 1600;"
            " s (0 0 0 0 0 0); }"
        });
        for (const word& name : fields.toc())
        {
            const auto setter = setters.find(name);
            if (setter == setters.end())
            {
                failUnknown(fields, name);
            }
            setter->second({dict, region, fields, ranges[k], particles});
        }
    }
}

} // namespace sph
