// Walls with bonded joints, on planes that dip: a static stage holds what the statics of rigid blocks holds,
// and lets fall what they do not.

#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dda/contact/candidates.hpp"
#include "dda/contact/detect.hpp"
#include "support/random_shapes.hpp"

namespace rockslope::limit_equilibrium_test {
namespace {

using namespace scene;

/// A running-bond wall of two to four rows on a fixed base; the base dips by `least_dip` to `steepest`, deg.
/// All joints have the same friction, cohesion, and tensile strength.
struct BondedWall {
    Scene scene;
    dda::MohrCoulomb law;

    double friction() const { return std::tan(law.friction_angle); }

    BondedWall(unsigned seed, double least_dip, double steepest, bool bears_tension) {
        RandomSource random(seed);
        const double dip = -radians(random.between(least_dip, steepest));
        law.friction_angle = law.residual_friction_angle = radians(random.between(15, 30));
        law.cohesion = random.between(5e3, 5e4);
        // At most that of the line of shear strength, where no shear strength is left.
        const double apex = law.cohesion / std::tan(law.friction_angle);
        law.tensile_strength = bears_tension ? random.between(0.1, 0.9) * std::min(apex, 2e4) : 0;
        scene.model.joint_materials[0].law = law;
        const auto add = [&](double x, double y, double width, double height, dda::Motion motion) {
            const Vec2 corner = placed(Vec2(x, y), dip, {0, 0});
            scene.box(corner, width, height, motion, dip);
        };
        const unsigned rows = 2 + random.index_below(3), columns = 2 + random.index_below(2);
        add(-1, -1, columns + 2, 1, dda::Motion::fixed);
        for (unsigned row = 0; row < rows; ++row) {
            const double offset = row % 2 == 0 ? 0 : random.between(0.3, 0.7);
            if (offset > 0) add(0, row, offset, 1, dda::Motion::free);
            for (unsigned c = 0; c + (offset > 0 ? 1 : 0) < columns; ++c)
                add(c + offset, row, 1, 1, dda::Motion::free);
            if (offset > 0) add(columns - 1 + offset, row, 1 - offset, 1, dda::Motion::free);
        }
    }
};

/// Short numbers keep the exact programme fast: multiples of 2^-16, of numbers of the order of 1.
double rounded(double number) {
    return std::ldexp(std::round(std::ldexp(number, 16)), -16);
}

/// The largest factor of gravity for which forces exist that balance each block and that the joints bear: a
/// linear programme over the forces of all contacts. 100 at most.
/// @param friction tangent of the friction angle, that of the joints or 0.
double collapse_factor(const BondedWall& wall, double friction) {
    const dda::Model& model = wall.scene.model;
    const dda::BlockSystem blocks = dda::initial_block_system(model);
    const double radius = 0.01;
    const double unit = 2500 * g;  // N per metre, the weight of a block of 1 m2
    const auto contacts =
        dda::detect_contacts(model, {model.vertices, model.vertices, radius},
                             dda::find_candidates(model, model.vertices, 2 * radius), ThreadPool(1));
    using Program = CGAL::Quadratic_program<double>;
    Program program(CGAL::EQUAL, false, 0, false, 0);
    const auto equation = [](dda::BlockIndex block, int component) { return 3 * block.value() + component; };
    int bound = equation(dda::BlockIndex(model.block_count()), 0), unknown = 1;
    for (const dda::Contact& contact : contacts) {
        if (!(contact.length > 0)) continue;
        const int normal = unknown++, shear = unknown++;
        program.set_l(normal, true, rounded(-wall.law.tensile_strength * contact.length / unit));
        for (const int side : {1, -1}) {
            const dda::BlockIndex block = side > 0 ? contact.corner_block : contact.edge_block;
            if (model.motion[block] != dda::Motion::free) continue;
            const Vec2 arm = contact.point - blocks.centroid(block);
            for (const auto& [column, force] :
                 {std::pair{normal, Vec2(side * contact.normal)}, {shear, Vec2(-side * contact.tangent)}}) {
                program.set_a(column, equation(block, 0), rounded(force.x()));
                program.set_a(column, equation(block, 1), rounded(force.y()));
                program.set_a(column, equation(block, 2), rounded(dda::cross(arm, force)));
            }
        }
        for (const int sign : {1, -1}) {
            program.set_r(bound, CGAL::SMALLER);
            program.set_a(shear, bound, sign);
            program.set_a(normal, bound, rounded(-friction));
            program.set_b(bound++, rounded(wall.law.cohesion * contact.length / unit));
        }
    }
    for (const dda::BlockIndex block : model.blocks())
        if (model.motion[block] == dda::Motion::free)
            program.set_a(0, equation(block, 1), rounded(-blocks.mass[block] * g / unit));
    program.set_u(0, true, 100);
    program.set_c(0, -1);
    const auto solution = CGAL::solve_linear_program(program, CGAL::Gmpzf());
    EXPECT_TRUE(solution.is_optimal());
    return -CGAL::to_double(solution.objective_value());
}

/// How a static stage ends under a factor of gravity.
struct Settled {
    dda::RunOutcome outcome;
    dda::BrokenBonds broken;
    double moved_after = 0;  ///< m, in a tenth of a second without a load of its own
};
Settled settled(const BondedWall& wall, double factor) {
    Scene scene = wall.scene;
    scene.model.gravity *= factor;
    Simulation sim(scene);
    dda::Stage stage;
    stage.kind = dda::StageKind::static_equilibrium;
    stage.control.step = 0.01;
    stage.displacement_limit = 0.1;
    stage.bonds_break_at_rest = true;
    const dda::RunOutcome outcome = sim.run(stage);
    const dda::BlockSystem before = sim.state.blocks;
    dda::Stage quiet;
    quiet.kind = dda::StageKind::dynamic;
    quiet.control.step = 0.005;
    quiet.duration = 0.1;
    if (outcome.status == dda::RunStatus::completed) sim.run(quiet);
    double moved = 0;
    for (const dda::BlockIndex block : scene.model.blocks())
        moved = std::max(moved, (sim.state.blocks.centroid(block) - before.centroid(block)).norm());
    return {outcome, sim.state.broken_bonds, moved};
}

class BondedWalls : public testing::TestWithParam<unsigned> {};

// Limit analysis bounds what friction without dilation holds: a wall stands if cohesion and tensile strength
// alone hold it, and falls if no forces within the strengths do [drucker1954]. The twentieth is for the
// shares of strength that hold, Eq. (97), and for the walls' change of shape.
TEST_P(BondedWalls, StandAndFallWhereLimitAnalysisSaysSo) {
    const BondedWall wall(GetParam(), 5, 60, true);
    const double lower = collapse_factor(wall, 0), upper = collapse_factor(wall, wall.friction());
    ASSERT_GT(lower, 0.01);
    ASSERT_LE(lower, upper);
    const Settled below = settled(wall, 0.95 * lower);
    EXPECT_EQ(below.outcome.status, dda::RunStatus::completed) << below.outcome.message;
    EXPECT_EQ(below.broken.events, 0);
    if (upper == 100) return;
    const Settled above = settled(wall, 1.05 * upper);
    EXPECT_EQ(above.outcome.status, dda::RunStatus::not_settled);
    EXPECT_GT(above.broken.events, 0);
}

// On planes that dip by twice the angle of friction a wall stands up to the upper bound. Its bonds keep a
// margin: they hold in the stage that follows, in which a bond that slips at all is broken.
TEST_P(BondedWalls, StandOnSteepPlanesWhereForcesExist) {
    const BondedWall wall(GetParam(), 50, 65, true);
    const double factor = collapse_factor(wall, wall.friction());
    const Settled near = settled(wall, 0.95 * factor);
    EXPECT_EQ(near.outcome.status, dda::RunStatus::completed) << near.outcome.message;
    EXPECT_EQ(near.broken.events, 0);
    EXPECT_LT(settled(wall, 0.75 * factor).moved_after, 1e-8);
}

// Cohesion without tensile strength: some walls stand under any gravity, and a column that leans out falls
// under none.
TEST_P(BondedWalls, StandWithoutTensionWhereLimitAnalysisSaysSo) {
    const BondedWall wall(GetParam(), 5, 30, false);
    const double lower = collapse_factor(wall, 0), upper = collapse_factor(wall, wall.friction());
    if (lower > 0.1) {
        EXPECT_EQ(settled(wall, 0.95 * lower).outcome.status, dda::RunStatus::completed);
    }
    if (upper < 100) {
        EXPECT_EQ(settled(wall, 1.05 * upper + 0.01).outcome.status, dda::RunStatus::not_settled);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, BondedWalls, testing::Range(1U, 5U), testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(LongSeeds, BondedWalls, testing::Range(5U, 31U), testing::PrintToStringParamName());

}  // namespace
}  // namespace rockslope::limit_equilibrium_test
