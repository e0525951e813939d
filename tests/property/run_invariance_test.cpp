// The result of a run must not depend on the order of the blocks, nor on position, orientation and units of
// the model, except for the amplified rounding errors.

#include <gtest/gtest.h>
#include <algorithm>

#include "support/random_shapes.hpp"
#include "support/scene.hpp"

namespace rockslope::run_invariance_test {
namespace {

using namespace scene;

constexpr double duration = .3;
constexpr double longest_step = .002;

/// Another description of the same model. Time is in seconds, because the engine has times of its own.
struct Description {
    double angle = 0;
    Vec2 shift{0, 0};
    double metre = 1;     ///< units of length per metre
    double kilogram = 1;  ///< units of mass per kilogram
    std::vector<int> order;

    int original(int block) const { return order.empty() ? block : order[block]; }
    Vec2 transformed(const Vec2& x) const { return metre * placed(x, angle, shift); }
    Vec2 transformed_back(const Vec2& x) const { return placed(x / metre - shift, -angle, Vec2(0, 0)); }
};

/// Random blocks above a trough.
struct Pile {
    std::vector<Ring> blocks;
    std::vector<Vec6> velocity;
};

Pile random_pile(unsigned seed) {
    RandomSource random(seed);
    Pile pile;
    pile.blocks.push_back({{-3, -1}, {3, -1}, {3, 1.2}, {.1, 0}, {-3, 1.5}});
    pile.velocity.push_back(Vec6::Zero());
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            const Vec2 place(.8 * column - 1.2 + random.between(-.03, .03),
                             .5 * std::abs(.8 * column - 1.2) + .45 + .75 * row);
            pile.blocks.push_back(random_ring_at(random, .5, place));
            Vec6 v = Vec6::Zero();
            v.head<2>() = Vec2(random.between(-.3, .3), -1);
            v[2] = random.between(-2, 2);
            pile.velocity.push_back(v);
        }
    }
    return pile;
}

Scene built(const Pile& pile, const Description& description) {
    Scene s;
    s.friction(30);
    for (int k = 0; k < static_cast<int>(pile.blocks.size()); ++k) {
        const auto b = static_cast<std::size_t>(description.original(k));
        Ring ring;
        for (const Vec2& v : pile.blocks[b]) ring.push_back(description.transformed(v));
        s.block({ring}, b == 0 ? dda::Motion::fixed : dda::Motion::free);
        Vec6 velocity = pile.velocity[b];
        velocity.head<2>() =
            description.metre * placed(Vec2(velocity.head<2>()), description.angle, Vec2(0, 0));
        s.model.initial_velocity.push_back(velocity);
    }
    // Per metre of thickness, a density is mass per area, and stresses and stiffnesses are force per length.
    s.model.gravity = description.metre * placed(s.model.gravity, description.angle, Vec2(0, 0));
    for (auto& rock : s.model.block_materials) {
        rock.density *= description.kilogram / (description.metre * description.metre);
        rock.youngs_modulus *= description.kilogram;
    }
    s.model.normal_penalty *= description.kilogram;
    s.model.shear_penalty *= description.kilogram;
    return s;
}

/// The final positions of all corners in the order and coordinates of the pile, and the error bound of the
/// run.
struct End {
    std::vector<std::vector<Vec2>> corners;
    double steps_error = 0;  ///< m, see ErrorSum
    std::size_t steps = 0;
    int hits = 0;      ///< closed contacts, summed over the steps
    double moved = 0;  ///< m, mean displacement of the blocks
};

/// Bound of the displacement error that the errors of the steps cause, m. The equations of a step are
/// satisfied up to coordinate rounding, for which the engine allows eight units, and up to the force
/// tolerance, which is the same fraction of the largest penetration. A contact may thus be wrong by e, and a
/// velocity by 2 e / dt, Eq. (16) with gamma = 1, for the rest of the run.
class ErrorSum {
  public:
    ErrorSum(double largest_coordinate, double force_tolerance)
        : rounding_(8 * 2.3e-16 * largest_coordinate), tolerance_(force_tolerance) {}
    void add(double time, const dda::StepReport& report) {
        const double error = rounding_ + tolerance_ * report.largest_penetration;
        sum_ += 2 * error / report.step * (duration - time + report.step);
    }
    double sum() const { return sum_; }

  private:
    double rounding_, tolerance_;
    double sum_ = 0;
};

End run(const Pile& pile, const Description& description = {}) {
    Simulation sim(built(pile, description));
    dda::Stage stage;
    stage.duration = duration;
    stage.control.step = longest_step;
    stage.control.force_tolerance = 1e-10;
    double largest = 0;
    for (const Vec2& v : sim.model.vertices) largest = std::max(largest, v.lpNorm<Eigen::Infinity>());
    ErrorSum error(largest, stage.control.force_tolerance);
    End end;
    sim.on_step = [&](const dda::State& state, const dda::StepReport& report) {
        error.add(state.time, report);
        for (const dda::Contact& c : state.contacts.contacts) end.hits += c.state != dda::ContactState::open;
    };
    const dda::RunOutcome outcome = sim.run(stage);
    EXPECT_EQ(outcome.status, dda::RunStatus::completed) << outcome.message;
    end.steps_error = error.sum() / description.metre;
    end.steps = sim.reports.size();
    end.corners.resize(pile.blocks.size());
    for (int b = 0; b < sim.model.block_count(); ++b) {
        auto& corners = end.corners[description.original(b)];
        for (const dda::CornerIndex k : sim.model.topology.corners_of(b))
            corners.push_back(description.transformed_back(sim.state.blocks.vertices[k]));
        end.moved += sim.moved(b).norm() / description.metre / (sim.model.block_count() - 1);
    }
    return end;
}

double difference(const End& one, const End& other) {
    double largest = 0;
    for (std::size_t b = 0; b < one.corners.size(); ++b) {
        for (std::size_t k = 0; k < one.corners[b].size(); ++k)
            largest = std::max(largest, (one.corners[b][k] - other.corners[b][k]).norm());
    }
    return largest;
}

class PileRun : public testing::TestWithParam<unsigned> {
  protected:
    /// The factor by which the pile amplifies a displacement error: the largest of three runs with random
    /// changes of positions and velocities. About 1e5: an impact gives a block the velocity 2 d / dt - v,
    /// which turns an error of d into one of the velocity that is 1000 / s times as large, and the block hits
    /// the next one.
    double error_growth() const {
        RandomSource random(GetParam() + 1000);
        double largest = 1;
        for (int k = 0; k < 3; ++k) {
            Pile nudged = pile;
            for (std::size_t b = 1; b < pile.blocks.size(); ++b) {
                const Vec2 nudge = nudge_size * random.direction();
                for (Vec2& v : nudged.blocks[b]) v += nudge;
                nudged.velocity[b].head<2>() += nudge_size / duration * random.direction();
            }
            largest = std::max(largest, difference(plain, run(nudged)) / (2 * nudge_size));
        }
        return largest;
    }
    static constexpr double nudge_size = 1e-9;  // m

    /// Expects the same final positions up to the amplified errors of both runs and of the initial
    /// coordinates.
    /// @param initial_error m, of the coordinates
    void expect_close(const End& end, double initial_error) const {
        const double bound = error_growth() * (initial_error + plain.steps_error + end.steps_error);
        ASSERT_LT(bound, 5e-3) << "with a bound above a hundredth of a block the test shows nothing";
        EXPECT_LT(difference(plain, end), bound);
        EXPECT_EQ(end.steps, plain.steps);
    }
    void expect_same(const Description& description) const { expect_close(run(pile, description), 0); }

    const Pile pile = random_pile(GetParam());
    const End plain = run(pile);
};

TEST_P(PileRun, FallsAndHasContacts) {
    EXPECT_GT(plain.moved, .1);
    EXPECT_GT(plain.hits, 10);
}

// The order of the blocks decides the order of summation and ties.
TEST_P(PileRun, DoesNotDependOnTheOrderOfTheBlocks) {
    RandomSource random(GetParam() + 2000);
    Description permuted;
    for (int k = 0; k < static_cast<int>(pile.blocks.size()); ++k) permuted.order.push_back(k);
    for (std::size_t b = permuted.order.size(); b > 1; --b)
        std::swap(permuted.order[b - 1], permuted.order[random.index_below(static_cast<unsigned>(b))]);
    expect_same(permuted);
}

TEST_P(PileRun, DoesNotDependOnTheOrientationOfTheModel) {
    RandomSource random(GetParam() + 3000);
    expect_same({random.between(0, 6), {random.between(-3, 3), random.between(-3, 3)}, 1, 1, {}});
}

TEST_P(PileRun, DoesNotDependOnUnits) {
    expect_same({0, {0, 0}, 1000, .001, {}});  // mm, t
    expect_same({0, {0, 0}, 1 / .3048, 1 / 14.59, {}});
}

// Coordinates of 1e6 m, as in a file, are rounded to half of 2^-33 m in x and in y. The reader then subtracts
// the origin of the model in whole metres.
TEST_P(PileRun, DoesNotDependOnThePositionOfTheModel) {
    Pile far = pile;
    const Vec2 place(1e6, -1e6);
    for (Ring& ring : far.blocks) {
        for (Vec2& v : ring) v = Vec2(v + place) - place;
    }
    const End end = run(far);
    EXPECT_GT(difference(plain, end), 0) << "the coordinates must have been rounded";
    expect_close(end, 0x1p-33 / std::sqrt(2.0));
}

INSTANTIATE_TEST_SUITE_P(Seeds, PileRun, testing::Range(1U, 9U), testing::PrintToStringParamName());

}  // namespace
}  // namespace rockslope::run_invariance_test
