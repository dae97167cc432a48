#include "scheme/ImplicitViscosity.H"

#include "runTime/log.H"
#include "scheme/MatrixFree.H"

#include <cmath>
#include <iostream>

namespace sph
{

struct ImplicitViscosity::Solver
{
    MatrixFree matrix;
    Eigen::ConjugateGradient
    <
        MatrixFree, Eigen::Lower | Eigen::Upper, BlockDiagonal
    > cg;

    explicit Solver(const ViscousSystem& system)
    :
        matrix(system)
    {}
};

bool ImplicitViscosity::selected(const dictionary& solution)
{
    return
        solution.getChoiceOrDefault
        (
            {"viscousIntegration", "of the force of Morris or Cleary"},
            "explicit", {"explicit", "implicit"}
        )
     == "implicit";
}

std::unique_ptr<ImplicitViscosity> ImplicitViscosity::New
(
    const dictionary& solution, const ViscousScheme& scheme,
    Particles& particles, const Boundaries& boundaries,
    Neighbourhood& neighbourhood, const Kernel& kernel
)
{
    if (!selected(solution))
    {
        // So that a case can change its mind by one word
        solution.markUsed("viscousSolver");
        return nullptr;
    }
    std::cout << "Selecting viscousIntegration implicit\n";
    return std::make_unique<ImplicitViscosity>
    (
        solution, scheme, particles, boundaries, neighbourhood, kernel
    );
}

ImplicitViscosity::ImplicitViscosity
(
    const dictionary& solution, const ViscousScheme& scheme,
    Particles& particles, const Boundaries& boundaries,
    Neighbourhood& neighbourhood, const Kernel& kernel
)
:
    particles_(particles),
    system_(scheme, particles, boundaries, neighbourhood, kernel),
    solver_(std::make_unique<Solver>(system_))
{
    if (!system_.solvable())
    {
        solution.fail
        (
            "viscousIntegration",
            "viscousIntegration implicit needs a symmetric operator:"
            " viscousScheme Morris or Cleary in system/sphSchemes"
        );
    }
    if (solution.found("sleep"))
    {
        solution.fail
        (
            "sleep", "Particles cannot sleep with viscousIntegration implicit"
        );
    }
    const dictionary& dict = solution.subOrEmptyDict
    (
        {"viscousSolver", "solver of an implicit step"}
    );
    tolerance_ = dict.getOrDefault
    (
        {"tolerance", "residual over the right-hand side"}, 1e-6,
        dimless, Range::positive()
    );
    relTol_ = dict.getOrDefault
    (
        {"relTol", "residual over that of the first guess"}, 0,
        dimless, Range::between(0, 1)
    );
    maxIter_ = dict.getLabelOrDefault
    (
        {"maxIter", "most iterations"}, 500, Range{1}
    );
}

ImplicitViscosity::~ImplicitViscosity() = default;

void ImplicitViscosity::resize()
{
    const label n = system_.size();
    for (ViscousSystem::Vector* x : {&U_, &guess_, &rhs_, &residual_})
    {
        x->resize(n);
    }
    solver_->matrix.resize();
}

void ImplicitViscosity::guess(const scalar deltaT)
{
    resize();
    system_.get(particles_.U, U_);
    system_.get(particles_.a, guess_);
    guess_ = U_ + deltaT*guess_;
}

void ImplicitViscosity::solve(const scalar deltaT)
{
    if (!(deltaT > 0))
    {
        return;
    }
    system_.assemble(deltaT);
    system_.rightHandSide(rhs_);

    auto& cg = solver_->cg;
    cg.compute(solver_->matrix);
    residual_ = rhs_ - solver_->matrix.times(guess_);
    const scalar scale = rhs_.norm();
    const scalar initial = scale == 0 ? 0 : residual_.norm()/scale;
    const scalar target = std::max(tolerance_, relTol_*initial);
    iterations_ = 0;
    finalResidual_ = initial;
    if (initial > target)
    {
        cg.setTolerance(target);
        cg.setMaxIterations(maxIter_);
        guess_ = cg.solveWithGuess(rhs_, guess_);
        finalResidual_ = cg.error();
        // Eigen does not count the last one if it is good enough
        iterations_ = label(cg.iterations()) + (finalResidual_ < target);
    }
    else if (scale == 0)
    {
        guess_.setZero();
    }
    report(initial, target);

    guess_ = (guess_ - U_)/deltaT;
    system_.set(particles_.U, U_);
    system_.set(particles_.a, guess_);
}

void ImplicitViscosity::report(const scalar initial, const scalar target)
{
    stepLog() << "PCG:  Solving for U, Initial residual = " << initial
        << ", Final residual = " << finalResidual_ << ", No Iterations "
        << iterations_ << '\n';
    if (!std::isfinite(initial) || !std::isfinite(finalResidual_))
    {
        throw Error
        (
            "The viscous solver has met a number that is not finite.\n"
            "A smaller maxCo, or a closer look at the last written time,"
            " may help."
        );
    }
    constexpr label every = 100;
    if (finalResidual_ > target && notConverged_++ % every == 0)
    {
        warning
        (
            "The viscous solver has not converged in maxIter "
          + std::to_string(maxIter_) + " iterations ("
          + std::to_string(notConverged_) + " times so far): raise maxIter,"
            " or lower maxCo"
        );
    }
}

} // namespace sph
