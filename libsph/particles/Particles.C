#include "particles/Particles.H"

#include "primitives/error.H"

#include <algorithm>

namespace sph
{

Particles::Particles(const scalar spacing)
:
    spacing_(spacing)
{
    using K = FieldKind;
    const bool yes = true, no = false;
    fields_ =
    {
        {"U", K::vector, {&U.x, &U.y}, yes, yes, "velocity [m/s]"},
        {"rho", K::scalar, {&rho}, yes, yes, "bulk density [kg/m3]"},
        {"m", K::scalar, {&m}, yes, yes, "mass per unit depth [kg/m]"},
        {
            "s", K::symmTensor, {&s.xx, &s.xy, &s.yy}, yes, no,
            "deviatoric stress [Pa]"
        },
        {"a", K::vector, {&a.x, &a.y}, yes, no, "acceleration [m/s2]"},
        {"Us", K::vector, {&Us.x, &Us.y}, yes, no, "shifting velocity [m/s]"},
        {"rhoDot", K::scalar, {&rhoDot}, yes, no, "density diffusion"},
        {"eta", K::scalar, {&eta}, yes, no, "effective viscosity [Pa s]"},
        {"asleep", K::scalar, {&asleep}, yes, no, "1: not advanced", no},
        {
            "Umean", K::vector, {&Umean.x, &Umean.y}, yes, no,
            "mean velocity of late [m/s]", no
        },
        {"V", K::scalar, {&V}, no, no, "volume per unit depth [m2]"},
        {"p", K::scalar, {&p}, no, no, "pressure [Pa]"},
        {"q", K::scalar, {&q}, no, no, "bulk viscous pressure [Pa]"},
        {
            "gradU", K::tensor, {&gradU.xx, &gradU.xy, &gradU.yx, &gradU.yy},
            no, no, "velocity gradient [1/s]"
        },
        {
            "gradRho", K::vector, {&gradRho.x, &gradRho.y}, no, no,
            "density gradient [kg/m4]"
        },
        {
            "L", K::symmTensor, {&L.xx, &L.xy, &L.yy}, no, no,
            "gradient correction (13)"
        },
        {"lambda", K::scalar, {&lambda}, no, no, "completeness of the kernel"},
        {"w", K::scalar, {&w}, no, no, "share of the corrected divergence"},
        {"div", K::scalar, {&div}, no, no, "velocity divergence [1/s]"},
        {"gammaDot", K::scalar, {&gammaDot}, no, no, "shear rate [1/s]"},
        {"I", K::scalar, {&I}, no, no, "inertial number (35)"},
        {
            "T", K::symmTensor, {&T.xx, &T.xy, &T.yy}, no, no,
            "stress over density squared [Pa m6/kg2]"
        },
        {"Vg", K::scalar, {&Vg}, no, no, "volume, 0 for walls [m2]"},
        {
            "illPosed", K::scalar, {&illPosed}, no, no,
            "C: > 0 where mu(I) is ill-posed", no
        },
        {"n", K::vector, {&n.x, &n.y}, no, no, "normal of a wall"},
        {"depth", K::scalar, {&depth}, no, no, "depth behind a wall [m]"},
        {"betaT", K::scalar, {&betaT}, no, no, "limit of beta along a wall"},
        {"betaN", K::scalar, {&betaN}, no, no, "limit of beta normal to it"},
        {
            "Uwall", K::vector, {&Uwall.x, &Uwall.y}, no, no,
            "velocity of a wall [m/s]"
        },
        {
            "tauWall", K::scalar, {&tauWall}, no, no,
            "elastic shear of a wall with friction [Pa]", no
        }
    };
    resize(0, 0);
}

const FieldInfo& Particles::fieldAt(const scalarField& component) const
{
    return *std::find_if
    (
        fields_.begin(), fields_.end(),
        [&](const FieldInfo& info)
        {
            return info.components.front() == &component;
        }
    );
}

const FieldInfo& Particles::field(const std::string& name) const
{
    const auto iter = std::find_if
    (
        fields_.begin(), fields_.end(),
        [&](const FieldInfo& info) { return info.name == name; }
    );
    if (iter == fields_.end())
    {
        wordList names;
        for (const FieldInfo& info : fields_)
        {
            names.push_back(info.name);
        }
        throw Error
        (
            "Unknown particle field " + name + "\n\nValid fields :\n\n"
          + listOfWords(names)
        );
    }
    return *iter;
}

void Particles::use(const std::string& name)
{
    for (FieldInfo& info : fields_)
    {
        info.used = info.used || info.name == name;
    }
}

void Particles::resizeAll(const label size)
{
    // One slice more than needed: lanes may be loaded from the null particle
    const std::size_t n = roundUpToLanes(size) + laneCount;
    resizeSparingly(r.x, n);
    resizeSparingly(r.y, n);
    for (FieldInfo& info : fields_)
    {
        for (scalarField* component : info.components)
        {
            resizeSparingly(*component, n);
        }
    }
    resizeSparingly(id, n, -1);
    resizeSparingly(patch, n, -1);
}

void Particles::setNull(const label i)
{
    r.x[i] = r.y[i] = 0;
    for (FieldInfo& info : fields_)
    {
        for (scalarField* component : info.components)
        {
            (*component)[i] = 0;
        }
    }
    rho[i] = 1;     // so that nobody divides by zero
    id[i] = -1;
    patch[i] = -1;
}

void Particles::resize(const label nGranular, const label nWall)
{
    const label oldGranular = nGranular_;
    const label oldWallBegin = wallBegin_;
    const label oldWall = nWall_;

    nGranular_ = nGranular;
    setAwake(nGranular, nGranular);
    wallBegin_ = roundUpToLanes(nGranular);
    nWall_ = nWall;
    ghostBegin_ = wallBegin_ + roundUpToLanes(nWall);

    const label keptWall =
        oldWallBegin == wallBegin_ ? std::min(oldWall, nWall) : 0;
    nGhost_ = 0;
    null_ = ghostBegin_;
    resizeAll(size());
    for (label i = std::min(oldGranular, nGranular); i < wallBegin_; ++i)
    {
        setNull(i);
    }
    for (label i = wallBegin_ + keptWall; i < label(r.x.size()); ++i)
    {
        setNull(i);
    }
}

void Particles::setAwake(const label nAwake, const label nActive)
{
    nAwake_ = std::min(roundUpToLanes(nAwake), nGranular_);
    nActive_ = std::min(roundUpToLanes(nActive), nGranular_);
}

void Particles::resizeGhosts(const label nGhost)
{
    nGhost_ = nGhost;
    null_ = ghostBegin_ + nGhost;
    if (roundUpToLanes(size()) + laneCount > label(r.x.size()))
    {
        // Head room, so that a growing number of ghosts seldom reallocates
        resizeAll(size() + nGhost/2);
    }
    setNull(null_);
}

void Particles::reorderGranular(const labelField& order)
{
    buffer_.resize(nGranular_);
    idBuffer_.resize(nGranular_);

    const auto permute = [&](scalarField& field)
    {
        #pragma omp parallel for schedule(static)
        for (label i = 0; i < nGranular_; ++i)
        {
            buffer_[i] = field[order[i]];
        }
        #pragma omp parallel for schedule(static)
        for (label i = 0; i < nGranular_; ++i)
        {
            field[i] = buffer_[i];
        }
    };

    permute(r.x);
    permute(r.y);
    permute(lambda);    // sleepers keep it
    for (FieldInfo& info : fields_)
    {
        if (info.state)
        {
            for (scalarField* component : info.components)
            {
                permute(*component);
            }
        }
    }
    for (label i = 0; i < nGranular_; ++i)
    {
        idBuffer_[i] = id[order[i]];
    }
    std::copy(idBuffer_.begin(), idBuffer_.end(), id.begin());
}

} // namespace sph
