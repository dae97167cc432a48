#include "benchmarks/HandWritten.H"

#include <cmath>

namespace sph
{

HandWritten::HandWritten
(
    const Particles& particles, const PairList& list,
    const Kernel& kernel, const Material& material, const vector& g
)
:
    P_(particles),
    list_(list),
    kernel_{1/(kernel.h()*kernel.h())},
    AhSqr_(kernel.h()*kernel.h()),
    pairing_(0.2/std::pow(kernel.W(particles.spacing()), 4)),
    shear_(0.3*material.eos().c()*kernel.h()/(4*material.rho0())),
    diffusion_(2*0.1*kernel.h()*material.eos().c()),
    g_(g)
{
    for
    (
        scalarField* f :
        {
            &L.xx, &L.xy, &L.yy, &gradU.xx, &gradU.xy, &gradU.yx, &gradU.yy,
            &gradRho.x, &gradRho.y, &Us.x, &Us.y, &a.x, &a.y, &lambda, &w,
            &div, &gammaDot, &rhoDot
        }
    )
    {
        f->resize(roundUpToLanes(particles.granular().end));
    }
}


// * * * * * * * * * * * * * * * *  Records * * * * * * * * * * * * * * * * //

template<std::size_t n>
static void pack
(
    const label end, const scalarField* const (&columns)[n],
    scalarField& records
)
{
    records.resize(std::size_t(roundUpToLanes(end))*n);
    for (label i = 0; i < end; i += nLanes)
    {
        for (std::size_t c = 0; c < n; c += nLanes)
        {
            laneRow rows[nLanes];
            for (label lane = 0; lane < nLanes; ++lane)
            {
                rows[lane] = loadRow<laneRow>(&(*columns[c + lane])[i]);
            }
            transpose(rows);
            for (label lane = 0; lane < nLanes; ++lane)
            {
                storeRow(rows[lane], &records[std::size_t(i + lane)*n + c]);
            }
        }
    }
}

void HandWritten::packGradients()
{
    pack
    (
        P_.size(),
        {
            &P_.r.x, &P_.r.y, &P_.V, &P_.U.x, &P_.U.y, &P_.rho,
            &P_.rho, &P_.rho    // fill the cache line
        },
        gradientRecords_
    );
}

void HandWritten::packForces()
{
    pack
    (
        P_.size(),
        {
            &P_.r.x, &P_.r.y, &P_.m, &P_.T.xx, &P_.T.xy, &P_.T.yy,
            &P_.U.x, &P_.U.y,
            &P_.gradU.xx, &P_.gradU.xy, &P_.gradU.yx, &P_.gradU.yy,
            &P_.Vg, &P_.rho, &P_.gradRho.x, &P_.gradRho.y
        },
        forceRecords_
    );
}

// * * * * * * * * * * * *  Fetch, and geometry  * * * * * * * * * * * * * * //

template<label nColumns, bool geometry, bool needsW>
scalar HandWritten::sumOfColumns(const scalarField& records) const
{
    lanes total = 0;
    label first = list_.first();
    for (const PairList::Slice& slice : list_.slices())
    {
        for (label lane = 0; lane < laneCount; lane += nLanes)
        {
            const lanes xi = load(&P_.r.x[first + lane]);
            const lanes yi = load(&P_.r.y[first + lane]);
            lanes sum[nColumns] = {}, sumF = 0, sumW = 0;
            for (label k = 0; k < slice.n; ++k)
            {
                lanes j[nColumns];
                fetch<nColumns>
                (
                    records.data(), slice.rows + k*laneCount + lane, j
                );
                for (label c = 0; c < nColumns; ++c)
                {
                    sum[c] += j[c];
                }
                if constexpr (geometry)
                {
                    const lanes x = xi - j[0], y = yi - j[1];
                    lanes F, W = 0;
                    kernel_.evaluate<needsW>(x*x + y*y, F, W);
                    sumF += F;
                    sumW += W;
                }
            }
            for (const lanes& s : sum)
            {
                total += s;
            }
            total += sumF + sumW;
        }
        first += laneCount;
    }
    return stdx::reduce(total);
}

scalar HandWritten::fetchForGradients() const
{
    return sumOfColumns<6, false, false>(gradientRecords_);
}

scalar HandWritten::fetchForForces() const
{
    return sumOfColumns<16, false, false>(forceRecords_);
}

scalar HandWritten::geometryForGradients() const
{
    return sumOfColumns<6, true, true>(gradientRecords_);
}

scalar HandWritten::geometryForForces() const
{
    return sumOfColumns<16, true, false>(forceRecords_);
}

} // namespace sph
