#include "benchmarks/HandWritten.H"

namespace sph
{

// * * * * * * * * * * * * * * * * Gradients * * * * * * * * * * * * * * * * //

struct HandWritten::GradientSums
{
    lanes Mxx = 0, Mxy = 0, Myy = 0;
    lanes Gxx = 0, Gxy = 0, Gyx = 0, Gyy = 0;
    lanes rhox = 0, rhoy = 0, sx = 0, sy = 0;
};

void HandWritten::gradients()
{
    label first = list_.first();
    for (const PairList::Slice& slice : list_.slices())
    {
        for (label lane = 0; lane < laneCount; lane += nLanes)
        {
            const label i = first + lane;
            const lanes xi = load(&P_.r.x[i]), yi = load(&P_.r.y[i]);
            const lanes ui = load(&P_.U.x[i]), vi = load(&P_.U.y[i]);
            const lanes rhoi = load(&P_.rho[i]);
            GradientSums sum;
            for (label k = 0; k < slice.n; ++k)
            {
                lanes j[6];
                fetch<6>
                (
                    gradientRecords_.data(), slice.rows + k*laneCount + lane, j
                );
                const lanes x = xi - j[0], y = yi - j[1];
                lanes F, W;
                kernel_.evaluate<true>(x*x + y*y, F, W);
                const lanes VF = j[2]*F;
                const lanes gx = VF*x, gy = VF*y;

                sum.Mxx -= gx*x;
                sum.Mxy -= gx*y;
                sum.Myy -= gy*y;

                const lanes u = j[3] - ui, v = j[4] - vi, rho = j[5] - rhoi;
                sum.Gxx += u*gx;
                sum.Gxy += u*gy;
                sum.Gyx += v*gx;
                sum.Gyy += v*gy;
                sum.rhox += rho*gx;
                sum.rhoy += rho*gy;

                const lanes W2 = W*W;
                const lanes s = 1.0 + pairing_*W2*W2;
                sum.sx += s*gx;
                sum.sy += s*gy;
            }
            setGradients(i, sum);
        }
        first += laneCount;
    }
}

// What follows from the sums of some particles
inline void HandWritten::setGradients(const label i, const GradientSums& sum)
{
    const lanes d = sum.Mxx - sum.Myy;
    const lanes least =
        0.5*(sum.Mxx + sum.Myy - sqrt(d*d + 4.0*sum.Mxy*sum.Mxy));
    const lanes guard = max(0.25 - least, lanes(0));
    const lanes Mxx = sum.Mxx + guard, Myy = sum.Myy + guard;
    const lanes invDet = 1.0/(Mxx*Myy - sum.Mxy*sum.Mxy);
    const lanes Lxx = invDet*Myy, Lxy = -invDet*sum.Mxy, Lyy = invDet*Mxx;
    const lanes bulk = clamp((least - 0.6)/(0.85 - 0.6), lanes(0), lanes(1));

    const lanes Gxx = sum.Gxx*Lxx + sum.Gxy*Lxy;
    const lanes Gxy = sum.Gxx*Lxy + sum.Gxy*Lyy;
    const lanes Gyx = sum.Gyx*Lxx + sum.Gyy*Lxy;
    const lanes Gyy = sum.Gyx*Lxy + sum.Gyy*Lyy;
    const lanes Dxx = 0.5*(Gxx - Gyy), Dxy = 0.5*(Gxy + Gyx);
    const lanes shearRate = 2.0*sqrt(Dxx*Dxx + Dxy*Dxy);
    const lanes rate = select(least > 0.75, -AhSqr_*shearRate, lanes(0));

    store(least, &lambda[i]);
    store(bulk, &w[i]);
    store(Lxx, &L.xx[i]);
    store(Lxy, &L.xy[i]);
    store(Lyy, &L.yy[i]);
    store(Gxx, &gradU.xx[i]);
    store(Gxy, &gradU.xy[i]);
    store(Gyx, &gradU.yx[i]);
    store(Gyy, &gradU.yy[i]);
    store(bulk*(Gxx + Gyy) + (1.0 - bulk)*(sum.Gxx + sum.Gyy), &div[i]);
    store(shearRate, &gammaDot[i]);
    store(Lxx*sum.rhox + Lxy*sum.rhoy, &gradRho.x[i]);
    store(Lxy*sum.rhox + Lyy*sum.rhoy, &gradRho.y[i]);
    store(rate*sum.sx, &Us.x[i]);
    store(rate*sum.sy, &Us.y[i]);
}


// * * * * * * * * * * * * * * * * *  Forces * * * * * * * * * * * * * * * * //

void HandWritten::forces()
{
    label first = list_.first();
    for (const PairList::Slice& slice : list_.slices())
    {
        for (label lane = 0; lane < laneCount; lane += nLanes)
        {
            const label i = first + lane;
            const lanes xi = load(&P_.r.x[i]), yi = load(&P_.r.y[i]);
            const lanes ui = load(&P_.U.x[i]), vi = load(&P_.U.y[i]);
            const lanes Txx = load(&P_.T.xx[i]), Txy = load(&P_.T.xy[i]);
            const lanes Tyy = load(&P_.T.yy[i]);
            const lanes Gxx = load(&P_.gradU.xx[i]);
            const lanes Gxy = load(&P_.gradU.xy[i]);
            const lanes Gyx = load(&P_.gradU.yx[i]);
            const lanes Gyy = load(&P_.gradU.yy[i]);
            const lanes rhoi = load(&P_.rho[i]);
            const lanes rhoxi = load(&P_.gradRho.x[i]);
            const lanes rhoyi = load(&P_.gradRho.y[i]);
            lanes ax = 0, ay = 0, qx = 0, qy = 0, rho = 0;
            for (label k = 0; k < slice.n; ++k)
            {
                lanes j[16];
                fetch<16>
                (
                    forceRecords_.data(), slice.rows + k*laneCount + lane, j
                );
                const lanes x = xi - j[0], y = yi - j[1];
                lanes F, W;
                kernel_.evaluate<false>(x*x + y*y, F, W);
                const lanes mF = j[2]*F;
                const lanes gx = mF*x, gy = mF*y;

                ax += (Txx + j[3])*gx + (Txy + j[4])*gy;
                ay += (Txy + j[4])*gx + (Tyy + j[5])*gy;

                const lanes du = (Gxx + j[8])*x + (Gxy + j[9])*y;
                const lanes dv = (Gyx + j[10])*x + (Gyy + j[11])*y;
                qx += mF*(ui - j[6] - 0.5*du);
                qy += mF*(vi - j[7] - 0.5*dv);

                const lanes drho = (rhoxi + j[14])*x + (rhoyi + j[15])*y;
                rho += j[12]*F*(rhoi - j[13] - 0.5*drho);
            }
            store(g_.x() + ax + shear_*qx, &a.x[i]);
            store(g_.y() + ay + shear_*qy, &a.y[i]);
            store(diffusion_*rho, &rhoDot[i]);
        }
        first += laneCount;
    }
}

} // namespace sph
