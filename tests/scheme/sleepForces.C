// Those that are awake feel sleepers as they would feel others at rest, also
// in the steps in which what sleepers carry is not packed again.
#include "scheme/SleepScene.H"
#include "support/precision.H"

#include <gtest/gtest.h>

namespace sph
{

namespace
{

constexpr scalar dx = 0.005, g = 9.81;
constexpr label nx = 44, ny = 20;

CaseText corner(const std::string& right)
{
    CaseText text;
    text.boundary =
        "bed { type noSlip; points ((0 0 0) (0.22 0 0)); }"
        "left { type symmetryPlane; point (0 0 0); normal (1 0 0); }";
    if (right == "freeSlip")
    {
        text.boundary +=
            "right { type freeSlip; points ((0.22 0 0) (0.22 0.15 0)); }";
    }
    if (right == "periodic")
    {
        text.boundary =
            "bed { type noSlip; points ((0 0 0) (0.22 0 0)); }"
            "ends { type periodic; point (0 0 0); translation (0.22 0 0); }";
    }
    return text;
}

// Awake: in the lower left corner, and around a point
bool sleeps(const vector& r)
{
    return
        r.norm() > 6.3*dx
     && (r - vector(nx - 2, 0.6*ny)*dx).norm() > 4.4*dx;
}

// Two scenes in the same state: in one of them some sleep
class twoScenes : public testing::TestWithParam<std::string>
{
    std::mt19937_64 engine_{3};

protected:
    CaseText text = corner(GetParam());
    Points points;
    std::unique_ptr<SleepScene> some, none;
    scalar dt = 0;

    void SetUp() override
    {
        if (GetParam() == "WendlandC2")
        {
            text.kernel = "kernel WendlandC2; hByDx 1.3;";
        }
        points = squareLattice({0, 0}, nx, ny, dx);
        shake(points, 0.15*dx);
        some = std::make_unique<SleepScene>(text, dx, points);
        none = std::make_unique<SleepScene>(text, dx, points);
        dt = some->acousticStep();
        std::vector<std::int64_t> all;
        for (label id = 0; id < nx*ny; ++id)
        {
            all.push_back(id);
            some->particles.asleep[id] = sleeps(points[id]);
        }
        vary(all, 0);
    }

    // Another state of those with these ids, in both scenes; those that sleep
    // have no velocity
    void vary(const std::vector<std::int64_t>& ids, const scalar shift)
    {
        std::uniform_real_distribution<scalar> number(-1, 1);
        std::map<std::int64_t, label> places[2] =
            {some->places(), none->places()};
        const scalar K = some->material.eos().K();
        for (const std::int64_t id : ids)
        {
            scalar x[8];
            std::generate(x, x + 8, [&] { return number(engine_); });
            const bool asleep = some->particles.asleep[places[0].at(id)];
            for (const bool all : {false, true})
            {
                Particles& P = (all ? none : some)->particles;
                const label i = places[all].at(id);
                P.r.set(i, P.r[i] + shift*vector(x[0], x[1]));
                P.U.set(i, asleep ? vector(0, 0) : vector(x[2], x[3])/10);
                P.rho[i] = CaseText::rho0*
                (
                    1 + 0.002*x[4]
                  + CaseText::rho0*g*(ny*dx - points[id].y())/K
                );
                P.V[i] = P.Vg[i] = P.m[i]/P.rho[i];
                P.s.xx[i] = 60*x[5];
                P.s.xy[i] = 60*x[6];
                P.s.yy[i] = -P.s.xx[i];
            }
        }
    }

    std::vector<std::int64_t> idsOf(const ParticleRange& range) const
    {
        const auto& id = some->particles.id;
        return {id.begin() + range.begin, id.begin() + range.end};
    }

    // Gradients and forces of a state in both scenes, density and stress left
    // as they are. Where nobody sleeps, those that sleep in the other scene
    // are given the rates that sleepers carry, which are theirs when lists are
    // new.
    void evaluate() const
    {
        const auto rebuilds = some->scheme.neighbourhood().rebuilds();
        for (SleepScene* scene : {some.get(), none.get()})
        {
            scene->scheme.updatePairs();
            scene->scheme.extrapolateVelocity();
            scene->scheme.gradients();
            scene->scheme.pressure();
        }
        const auto places = none->places();
        const Particles& S = some->particles;
        Particles& N = none->particles;
        if (some->scheme.neighbourhood().rebuilds() > rebuilds)
        {
            expectSame(S.watching(), {"gradU", "gradRho", "L", "lambda"});
        }
        for (label i = S.sleepers().begin; i < S.sleepers().end; ++i)
        {
            const label j = places.at(S.id[i]);
            N.q[j] = S.q[i];
            N.gradU.set(j, S.gradU[i]);
            N.gradRho.set(j, S.gradRho[i]);
        }
        for (SleepScene* scene : {some.get(), none.get()})
        {
            scene->scheme.stress();
            scene->scheme.extrapolateStress();
            scene->scheme.forces(dt);
        }
    }

    // Fields of those in range are those of the scene where nobody sleeps
    void expectSame(const ParticleRange& range, const wordList& names) const
    {
        const auto places = none->places();
        const Particles& S = some->particles;
        const Particles& N = none->particles;
        for (const word& name : names)
        {
            const auto& ours = S.field(name).components;
            const auto& theirs = N.field(name).components;
            for (std::size_t c = 0; c < ours.size(); ++c)
            {
                scalar largest = 1e-300, difference = 0;
                for (label i = range.begin; i < range.end; ++i)
                {
                    const bool granular = i < S.granular().end;
                    const label j = granular ? places.at(S.id[i]) : i;
                    largest = std::max(largest, std::abs((*theirs[c])[j]));
                    difference = std::max
                    (
                        difference, std::abs((*ours[c])[i] - (*theirs[c])[j])
                    );
                }
                // In single precision the order of pairs counts
                EXPECT_LT(difference, rounding(1e-11, 3e-6)*largest)
                    << name << ' ' << c;
            }
        }
    }

    void expectSameForces() const
    {
        const Particles& P = some->particles;
        expectSame
        (
            P.awake(),
            {
                "a", "rhoDot", "gradU", "div", "gammaDot", "Us", "gradRho",
                "L", "lambda", "w", "p", "q", "T", "V"
            }
        );
        expectSame(P.watching(), {"a", "p", "V"});
        expectSame(P.walls(), {"U", "p", "rho", "s", "q", "gradU", "T"});
    }
};

} // namespace

TEST_P(twoScenes, sleepersAreFeltAsThoseAtRest)
{
    evaluate();
    expectSameForces();
    const Particles& P = some->particles;
    EXPECT_GT(P.awake().size(), 40);
    EXPECT_GT(P.watching().size(), 60);
    EXPECT_GT(P.granular().end - P.active().end, 100);
    EXPECT_EQ(none->asleep(), 0);
}

// Lists stay while those that are awake move and change
TEST_P(twoScenes, soTheyAreInTheStepsAfterwards)
{
    evaluate();
    const auto rebuilds = some->scheme.neighbourhood().rebuilds();
    for (label step = 0; step < 4; ++step)
    {
        vary(idsOf(some->particles.awake()), 0.01*dx);
        evaluate();
        expectSameForces();
    }
    EXPECT_EQ(some->scheme.neighbourhood().rebuilds(), rebuilds);
}

// New lists, without and with a sort; images of sleepers too
TEST_P(twoScenes, andWithNewLists)
{
    evaluate();
    for (label step = 0; step < 6; ++step)
    {
        const auto rebuilds = some->scheme.neighbourhood().rebuilds();
        const bool sort = step % 3 == 2;
        vary(idsOf(some->particles.awake()), sort ? 0 : 0.15*dx);
        if (sort)
        {
            some->scheme.neighbourhood().reset();
        }
        evaluate();
        expectSameForces();
        EXPECT_EQ(some->scheme.neighbourhood().rebuilds(), rebuilds + 1);
    }
}

INSTANTIATE_TEST_SUITE_P
(
    boundaries, twoScenes,
    testing::Values("open", "freeSlip", "periodic", "WendlandC2"),
    [](const auto& info) { return info.param; }
);

} // namespace sph
