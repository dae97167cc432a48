#include "fuzz/targets.H"

#include "io/caseIO.H"
#include "primitives/error.H"

#include <cmath>
#include <fstream>
#include <unistd.h>

namespace sph
{

namespace
{

namespace fs = std::filesystem;

// A time folder in memory where there is some, removed at the end
struct TimeFolder
{
    fs::path path;

    TimeFolder()
    {
        const fs::path memory = "/dev/shm";
        const fs::path parent =
            fs::is_directory(memory) && ::access(memory.c_str(), W_OK) == 0
          ? memory : fs::temp_directory_path();
        std::string name = (parent/"sphFuzzXXXXXX").string();
        path = ::mkdtemp(name.data());
    }
    ~TimeFolder()
    {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }

    void write(const std::string& file, const std::string& bytes) const
    {
        std::ofstream(path/file, std::ios::binary) << bytes;
    }
};

void expectFinite
(
    const scalarField& values, const ParticleRange& range,
    const std::string& name
)
{
    for (label i = range.begin; i < range.end; ++i)
    {
        if (!std::isfinite(values[i]))
        {
            throw std::logic_error(name + " is read but not finite");
        }
    }
}

void expectSound(const Particles& P)
{
    if
    (
        P.granular().size() < 1 || P.walls().size() < 0
     || label(P.r.x.size()) < P.walls().end
     || !(P.spacing() > 0) || !std::isfinite(P.spacing())
    )
    {
        throw std::logic_error("sizes do not fit");
    }
    for (const ParticleRange& range : {P.granular(), P.walls()})
    {
        expectFinite(P.r.x, range, "r");
        expectFinite(P.r.y, range, "r");
        expectFinite(P.n.x, range, "n");
        expectFinite(P.n.y, range, "n");
        for (const FieldInfo& info : P.fields())
        {
            for (const scalarField* component : info.components)
            {
                expectFinite(*component, range, info.name);
            }
        }
        for (label i = range.begin; i < range.end; ++i)
        {
            if (!(P.m[i] > 0 && P.rho[i] > 0))
            {
                throw std::logic_error("a particle without mass or density");
            }
        }
    }
    for (label i = P.walls().begin; i < P.walls().end; ++i)
    {
        if (P.patch[i] < 0)
        {
            throw std::logic_error("a wall particle of no patch");
        }
    }
}

void writeGood(const fs::path& folder)
{
    Particles particles(0.1);
    particles.resize(2, 0);
    for (label i = 0; i < 2; ++i)
    {
        particles.r.set(i, {0.1*i, 0});
        particles.id[i] = i;
        particles.m[i] = particles.V[i] = 1;
    }
    writeState(particles, 0, folder, {});
}

} // namespace


void readAnyState(const std::string& bytes)
{
    static const TimeFolder material, wall;
    static const bool made = (writeGood(wall.path), true);
    (void)made;

    material.write("granular.vtp", bytes);
    wall.write("walls.vtp", bytes);
    Particles particles;
    std::unique_ptr<Error> refused;
    for (const TimeFolder* folder : {&wall, &material})
    {
        refused.reset();
        try
        {
            readState(folder->path, particles);
            expectSound(particles);
        }
        catch (const Error& error)
        {
            refused = std::make_unique<Error>(error.block());
        }
    }
    if (refused)
    {
        throw *refused;
    }
}

} // namespace sph
