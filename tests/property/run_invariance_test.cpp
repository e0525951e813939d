// Whole runs: neither the order of the blocks nor where the model is, which way it is turned nor its units
// change how a pile comes down, but for rounding and what the pile makes of it.

#include <gtest/gtest.h>

#include "support/random_shapes.hpp"

using namespace rockslope;

namespace {

using namespace scene;

constexpr double duration = .3;
constexpr double longest_step = .002;

/// How a model is told in another way. Time stays in seconds, in which the engine's own times are.
struct Telling {
    double angle = 0;
    Vec2 shift{0, 0};
    double metre = 1;     ///< how many units of length a metre is
    double kilogram = 1;  ///< and of mass
    std::vector<int> order;

    int original(int block) const { return order.empty() ? block : order[static_cast<std::size_t>(block)]; }
    Vec2 told(const Vec2& x) const { return metre * placed(x, angle, shift); }
    Vec2 untold(const Vec2& x) const { return placed(x / metre - shift, -angle, Vec2(0, 0)); }
};

/// Blocks of all kinds above a trough.
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
            pile.blocks.push_back(placed(random_ring(random, .5), random.between(0, 6), place));
            Vec6 v = Vec6::Zero();
            v.head<2>() = Vec2(random.between(-.3, .3), -1);
            v[2] = random.between(-2, 2);
            pile.velocity.push_back(v);
        }
    }
    return pile;
}

Scene built(const Pile& pile, const Telling& telling) {
    Scene s;
    s.friction(30);
    for (int k = 0; k < static_cast<int>(pile.blocks.size()); ++k) {
        const auto b = static_cast<std::size_t>(telling.original(k));
        Ring ring;
        for (const Vec2& v : pile.blocks[b]) ring.push_back(telling.told(v));
        s.block({ring}, b == 0 ? dda::Motion::fixed : dda::Motion::free);
        Vec6 velocity = pile.velocity[b];
        velocity.head<2>() = telling.metre * placed(Vec2(velocity.head<2>()), telling.angle, Vec2(0, 0));
        s.model.initial_velocity.push_back(velocity);
    }
    // Per metre of thickness: a density is a mass on an area, stresses and stiffnesses are forces on a
    // length.
    s.model.gravity = telling.metre * placed(s.model.gravity, telling.angle, Vec2(0, 0));
    for (auto& rock : s.model.block_materials) {
        rock.density *= telling.kilogram / (telling.metre * telling.metre);
        rock.youngs_modulus *= telling.kilogram;
    }
    s.model.normal_penalty *= telling.kilogram;
    s.model.shear_penalty *= telling.kilogram;
    return s;
}

/// Where all corners are in the end, in the pile's own order and coordinates, and what a step may have cost.
struct End {
    std::vector<std::vector<Vec2>> corners;
    double steps_error = 0;  ///< m, see below
    std::size_t steps = 0;
    int hits = 0;      ///< closed contacts, summed over the steps
    double moved = 0;  ///< m, on average
};

/// A step's equations are met up to the rounding of coordinates, of which the engine allows for eight units,
/// and up to the share of the largest contact force that convergence is told by, which is that share of a
/// penetration. A contact may thus be off by e, and a velocity by 2 e / dt, Eq. (16) with gamma = 1, for the
/// rest of the run. The sum over the steps is the largest way that comes of it, m.
class ErrorSum {
  public:
    ErrorSum(double largest_coordinate, double force_tolerance)
        : rounding_(8 * 2.3e-16 * largest_coordinate), tolerance_(force_tolerance) {}
    void add(double time, const dda::StepReport& report) {
        const double off = rounding_ + tolerance_ * report.largest_penetration;
        sum_ += 2 * off / report.step * (duration - time + report.step);
    }
    double sum() const { return sum_; }

  private:
    double rounding_, tolerance_;
    double sum_ = 0;
};

End run(const Pile& pile, const Telling& telling = {}) {
    Simulation sim(built(pile, telling));
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
    end.steps_error = error.sum() / telling.metre;
    end.steps = sim.reports.size();
    end.corners.resize(pile.blocks.size());
    for (int b = 0; b < sim.model.block_count(); ++b) {
        const auto& first = sim.model.topology.block_corners;
        auto& corners = end.corners[static_cast<std::size_t>(telling.original(b))];
        for (int k = first[static_cast<std::size_t>(b)]; k < first[static_cast<std::size_t>(b) + 1]; ++k)
            corners.push_back(telling.untold(sim.state.blocks.vertices[static_cast<std::size_t>(k)]));
        end.moved += sim.moved(b).norm() / telling.metre / (sim.model.block_count() - 1);
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
    /// How many times as far blocks are off in the end as they were put or would have flown by themselves:
    /// the most of a few piles with all blocks shifted and kicked at random. Some 1e5: a block that comes off
    /// an impact with 2 d / dt - v has d off by the error and its speed by 1000 / s of it, and hits the next.
    double growth() const {
        RandomSource random(GetParam() + 1000);
        double most = 1;
        for (int k = 0; k < 3; ++k) {
            Pile nudged = pile;
            for (std::size_t b = 1; b < pile.blocks.size(); ++b) {
                const Vec2 nudge = nudge_size * random.direction();
                for (Vec2& v : nudged.blocks[b]) v += nudge;
                nudged.velocity[b].head<2>() += nudge_size / duration * random.direction();
            }
            most = std::max(most, difference(plain, run(nudged)) / (2 * nudge_size));
        }
        return most;
    }
    static constexpr double nudge_size = 1e-9;  // m

    /// The same end, but for what the pile makes of the errors of two runs' steps, and of coordinates that
    /// were off by `first` in the beginning.
    void expect_close(const End& end, double first) const {
        const double bound = growth() * (first + plain.steps_error + end.steps_error);
        ASSERT_LT(bound, 5e-3) << "a hundredth of a block: beyond that the test tells nothing";
        EXPECT_LT(difference(plain, end), bound);
        EXPECT_EQ(end.steps, plain.steps);
    }
    void expect_same(const Telling& telling) const { expect_close(run(pile, telling), 0); }

    const Pile pile = random_pile(GetParam());
    const End plain = run(pile);
};

TEST_P(PileRun, ComesDownAndHits) {
    EXPECT_GT(plain.moved, .1);
    EXPECT_GT(plain.hits, 10);
}

// The order decides in what order sums are taken, and between ties.
TEST_P(PileRun, DoesNotDependOnTheOrderOfTheBlocks) {
    RandomSource random(GetParam() + 2000);
    Telling permuted;
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

// Coordinates of 1e6 m as a file has them, rounded to half of 2^-33 m in x and in y, and less the whole
// metres of the model's origin again, as readers do.
TEST_P(PileRun, DoesNotDependOnThePositionOfTheModel) {
    Pile far = pile;
    const Vec2 place(1e6, -1e6);
    for (Ring& ring : far.blocks) {
        for (Vec2& v : ring) v = Vec2(v + place) - place;
    }
    const End end = run(far);
    EXPECT_GT(difference(plain, end), 0) << "it was rounded";
    expect_close(end, 0x1p-33 / std::sqrt(2.0));
}

INSTANTIATE_TEST_SUITE_P(Seeds, PileRun, testing::Range(1U, 9U), testing::PrintToStringParamName());

}  // namespace
