#include "setup/setFieldValues.H"

#include "setup/createParticles.H"

namespace sph
{

namespace
{

void setU(const dictionary& fields, const ParticleRange& range, Particles& p)
{
    const vector U = fields.getVector("U", dimVelocity);
    for (label i = range.begin; i < range.end; ++i)
    {
        p.U.set(i, U);
    }
}

void setRho(const dictionary& fields, const ParticleRange& range, Particles& p)
{
    const scalar rho = fields.get("rho", dimDensity, Range::positive());
    for (label i = range.begin; i < range.end; ++i)
    {
        p.rho[i] = rho;
    }
}

void setS(const dictionary& fields, const ParticleRange& range, Particles& p)
{
    const auto s = fields.get<std::vector<scalar>>("s");
    if (s.size() != 6 || s[2] != 0 || s[4] != 0 || s[5] != 0)
    {
        fields.fail
        (
            "s", "A symmetric tensor of the plane has the six components"
            " (xx xy 0 yy 0 0)"
        );
    }
    const tensor value = (tensor() << s[0], s[1], s[1], s[3]).finished();
    for (label i = range.begin; i < range.end; ++i)
    {
        p.s.set(i, value);
    }
}

using Setter = void (*)(const dictionary&, const ParticleRange&, Particles&);

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
    const std::vector<RegionParticles>& regions, Particles& particles
)
{
    const std::vector<ParticleRange> ranges = rangesOf(regions);
    for (std::size_t k = 0; k < regions.size(); ++k)
    {
        const dictionary& fields = regions[k].dict->subOrEmptyDict("fields");
        for (const word& name : fields.toc())
        {
            const auto setter = setters.find(name);
            if (setter == setters.end())
            {
                failUnknown(fields, name);
            }
            setter->second(fields, ranges[k], particles);
        }
    }
}

} // namespace sph
