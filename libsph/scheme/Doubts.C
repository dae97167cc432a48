#include "scheme/Doubts.H"

#include "runTime/log.H"
#include "scheme/filling.H"
#include "scheme/roughness.H"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace sph
{

Doubts::Doubts(const Particles& particles, const Material& material)
:
    particles_(particles),
    material_(material)
{}

label Doubts::few() const
{
    return std::max(4, particles_.granular().end/200);
}

void Doubts::look(const scalar time, const label netHits)
{
    if (looks_++ % interval == 0 && !fast_)
    {
        lookAtSpeeds(time);
    }
    if (!caught_ && netHits > particles_.granular().end)
    {
        caught_ = true;
        std::ostringstream os;
        os  << "Until time " << time << " the last net of the walls has been"
            << " called " << netHits << " times (there are "
            << particles_.granular().end << "\n    particles): pressure does"
            << " not keep all of them off the walls. A smaller spacing, a\n"
            << "    greater KFactor or H, or other choices in"
            << " system/sphSchemes may";
        warning(os.str());
    }
}

void Doubts::lookAtSpeeds(const scalar time)
{
    const label n = particles_.granular().end;
    const scalar* Ux = particles_.U.x.data();
    const scalar* Uy = particles_.U.y.data();
    const scalar c = material_.eos().c(), limit = c*c/25;
    label fast = 0;
    #pragma omp simd reduction(+: fast)
    for (label i = 0; i < n; ++i)
    {
        fast += Ux[i]*Ux[i] + Uy[i]*Uy[i] > limit;
    }
    if (fast > few())
    {
        fast_ = true;
        std::ostringstream os;
        os  << "At time " << time << ' ' << fast << " particles are faster than"
            << " a fifth of the sound speed, " << c << " m/s:\n"
            << "    their impacts compress the material by several per cent."
            << " A greater KFactor or H of\n    the equation of state, or"
            << " adaptive yes, makes it stiffer";
        warning(os.str());
    }
}

bool Doubts::pressed() const
{
    const label n = particles_.granular().end;
    const scalar* p = particles_.p.data();
    const scalar limit = 1e-4*material_.eos().K();
    label pressed = 0;
    #pragma omp simd reduction(+: pressed)
    for (label i = 0; i < n; ++i)
    {
        pressed += std::abs(p[i]) > limit;
    }
    return pressed > few();
}

void Doubts::end() const
{
    if (looks_ == 0)
    {
        return;
    }
    std::ostringstream os;
    if (!pressed())
    {
        os  << "At the end the pressures are less than 1e-4 of the bulk"
            << " modulus, " << material_.eos().K() << " Pa:\n    the noise of"
            << " the densities covers them. A lower K, KFactor or H, or\n"
            << "    adaptive yes, would show them";
        warning(os.str());
    }
    const auto rough = roughness(particles_);
    if (rough && *rough > 0.3)
    {
        os.str("");
        os.precision(2);
        os  << "At the end the pressures of neighbours differ by "
            << 100 * *rough << " % of the RMS pressure\n    without order:"
            << " they are noise as much as pressure. More density diffusion"
            << " (stabilisation)\n    or artificial viscosity, or another"
            << " correction, may calm them";
        warning(os.str());
    }
    const auto filled = filling(particles_);
    const scalar excess = filled ? 1 / *filled - 1 : 0;
    if (std::abs(excess) > 0.1)
    {
        os.str("");
        os.precision(2);
        os  << "At the end the inner material takes " << std::abs(100*excess)
            << " % " << (excess > 0 ? "more" : "less") << " room than its"
            << " densities say: it was\n    torn apart and has come together"
            << " otherwise. Heights and volumes are wrong by as much.\n"
            << "    #includeEtc \"caseDicts/impact/sphSchemes\" at the end of"
            << " system/sphSchemes prevents it";
        warning(os.str());
    }
}

} // namespace sph
