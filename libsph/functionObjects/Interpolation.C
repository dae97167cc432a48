#include "functionObjects/Interpolation.H"

#include <Eigen/Eigenvalues>

#include <limits>

namespace sph
{

// Of the support, in spacings
static constexpr scalar radiusByDx = 2.6;

// Least share of the kernel that is filled in the material
static constexpr scalar leastFilling = 0.2;

// Least variance of the neighbours across the line that they are nearest to,
// over the squared radius; 0.1 where the support is full
static constexpr scalar leastVariance = 0.005;


Interpolation::Interpolation(const Particles& particles)
:
    particles_(particles),
    radius_(radiusByDx*particles.spacing())
{
    grid_.build(particles.r, {particles.granular()}, radius_);
}


std::vector<Interpolation::Weight> Interpolation::neighbours
(
    const vector& point
) const
{
    CellGrid::Run runs[3];
    grid_.runsAround(point.x(), point.y(), runs);
    std::vector<Weight> list;
    for (const CellGrid::Run& run : runs)
    {
        for (label e = run.begin; e < run.end; ++e)
        {
            const label j = grid_.particles()[e];
            const vector d = (particles_.r[j] - point)/radius_;
            const scalar q = d.norm();
            if (q < 1)
            {
                const scalar V = particles_.m[j]/particles_.rho[j];
                const scalar W =
                    7/(M_PI*radius_*radius_)*std::pow(1 - q, 4)*(1 + 4*q);
                list.push_back({j, d, V*W});
            }
        }
    }
    return list;
}


void Interpolation::correct(std::vector<Weight>& weights)
{
    scalar sum = 0;
    vector mean = vector::Zero();
    for (const Weight& weight : weights)
    {
        sum += weight.c;
        mean += weight.c*weight.d;
    }
    mean /= sum;
    tensor variance = tensor::Zero();
    for (Weight& weight : weights)
    {
        weight.c /= sum;
        const vector off = weight.d - mean;
        variance += weight.c*off*off.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<tensor> eigen(variance);
    if (eigen.eigenvalues()[0] < leastVariance)
    {
        return;
    }
    // e.M^-1 b, with M taken about the mean
    const vector slope = variance.inverse()*mean;
    for (Weight& weight : weights)
    {
        weight.c *= 1 - slope.dot(weight.d - mean);
    }
}


std::vector<scalar> Interpolation::at
(
    const vector& point, const std::vector<const scalarField*>& components
) const
{
    std::vector<Weight> weights = neighbours(point);
    scalar filling = 0;
    for (const Weight& weight : weights)
    {
        filling += weight.c;
    }
    if (filling < leastFilling)
    {
        return std::vector<scalar>
        (
            components.size(), std::numeric_limits<scalar>::quiet_NaN()
        );
    }
    correct(weights);
    std::vector<scalar> values;
    for (const scalarField* component : components)
    {
        scalar value = 0;
        for (const Weight& weight : weights)
        {
            value += weight.c*(*component)[weight.j];
        }
        values.push_back(value);
    }
    return values;
}

} // namespace sph
