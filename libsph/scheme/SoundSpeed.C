#include "scheme/SoundSpeed.H"

#include "scheme/BulkModulusState.H"
#include "scheme/changeBulkModulus.H"

#include <cmath>
#include <sstream>

namespace sph
{

// Ratio of two values of K, one after the other
static constexpr scalar rung = 1.1;

SoundSpeed::SoundSpeed
(
    EquationOfState& eos, const vector& g, Particles& particles,
    const scalar time
)
:
    eos_(eos),
    particles_(particles),
    burden_(particles, g, eos.rho0()),
    magG_(g.norm()),
    minK_(eos.KFactor()*eos.rho0()*magG_*4*particles.spacing()),
    maxK_(maxRise*eos.K()),
    windowStart_(time)
{
    if (eos_.adaptive())
    {
        openWindow(time, minK_);
    }
}

scalar SoundSpeed::K(const label rungs) const
{
    return eos_.K()*std::pow(rung, rungs);
}

void SoundSpeed::openWindow(const scalar time, const scalar leastK)
{
    windowStart_ = time;
    windowRungs_ = 0;
    while (K(windowRungs_ - 1) >= leastK)
    {
        --windowRungs_;
    }
}

void SoundSpeed::look()
{
    while
    (
        K(windowRungs_) < maxK_
     && burden_.exceeds(K(windowRungs_)/eos_.KFactor())
    )
    {
        ++windowRungs_;
    }
}

bool SoundSpeed::move(const bool down)
{
    if (windowRungs_ <= 0 && !(down && windowRungs_ < -1))
    {
        return false;
    }
    change(K(windowRungs_));
    windowRungs_ = 0;
    return true;
}

void SoundSpeed::change(const scalar K)
{
    changeBulkModulus(eos_, particles_, K, magG_);
}

scalar SoundSpeed::windowLength() const
{
    const scalar Hs =
        K(windowRungs_)/(eos_.KFactor()*eos_.rho0()*magG_);
    return 4*Hs/eos_.c();
}

bool SoundSpeed::follow(const scalar time)
{
    if (!eos_.adaptive())
    {
        return false;
    }
    look();
    const bool closed = time - windowStart_ >= windowLength();
    const bool moved = move(closed);
    if (closed)
    {
        openWindow(time, minK_);
    }
    return moved;
}

void SoundSpeed::checkRise() const
{
    if (burden_.exceeds(eos_.K()/eos_.KFactor()))
    {
        std::ostringstream os;
        os  << "The start needs more than " << maxRise << " times the bulk"
            << " modulus of the equation of state,\nwhich adaptive yes does"
            << " not give it. Give a greater H: the material is "
            << burden_.height() << " m high.";
        throw Error(os.str());
    }
}

void SoundSpeed::checkStrain(const scalar stateK) const
{
    const scalar p = burden_.greatestPressure();
    if (p > eos_.K())
    {
        std::ostringstream os;
        os  << "The pressures of the start, up to " << p << " Pa, belong to a"
            << " bulk modulus of " << stateK << " Pa\nand exceed the present"
            << " one, " << eos_.K() << " Pa. Run setParticles again, or mend"
            << " K, or\nKFactor and H, of the equation of state.";
        throw Error(os.str());
    }
}

void SoundSpeed::start(const std::filesystem::path& timeFolder)
{
    const scalar K = eos_.K();
    const auto state = BulkModulusState::read(timeFolder);
    const scalar stateK = state ? state->K : K;
    eos_.setK(stateK);
    checkPressures(eos_, particles_, burden_.greatestPressure());
    eos_.correct(particles_.granular(), particles_.rho, particles_.p);
    if (stateK != K)
    {
        change(K);
    }
    if (eos_.adaptive())
    {
        const scalar atRest = eos_.KFactor()*burden_.weight();
        openWindow(windowStart_, std::max(minK_, atRest));
        look();
        move(true);
        checkRise();
        openWindow(windowStart_, minK_);
    }
    if (eos_.K() != stateK)
    {
        checkStrain(stateK);
    }
}

void SoundSpeed::read(const std::filesystem::path& timeFolder)
{
    const auto state = BulkModulusState::read(timeFolder);
    if (!state && eos_.adaptive())
    {
        throw IOError
        (
            "There is no such file: nobody knows the bulk modulus of this time,"
            " which\nadaptive yes lets follow\n\nRemove this time folder to"
            " start from the one before it",
            BulkModulusState::file(timeFolder).string()
        );
    }
    if (!state)
    {
        return;
    }
    const scalar K = eos_.K();
    eos_.setK(state->K);
    if (!eos_.adaptive())
    {
        if (eos_.K() != K)
        {
            change(K);
        }
        return;
    }
    openWindow(windowStart_, minK_);
    if (state->window)
    {
        windowStart_ = state->window->start;
        windowRungs_ = state->window->rungs;
    }
}

void SoundSpeed::write(const std::filesystem::path& timeFolder) const
{
    BulkModulusState state{eos_.K()};
    if (eos_.adaptive())
    {
        state.window = {windowStart_, windowRungs_};
    }
    state.write(timeFolder);
}

} // namespace sph
