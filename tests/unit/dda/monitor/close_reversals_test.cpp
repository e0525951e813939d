// Counter-slips near the least slip of a reversal: on paths whose slips are known, and in a list of its own.

#include "dda/monitor/close_reversals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "support/cyclic_joints.hpp"
#include "support/scene.hpp"

namespace rockslope::close_reversals_test {
namespace {

using dda::CloseReversals;
using dda::CounterSlip;
using joint_tests::counting_joint;
using namespace scene;
using testing::ElementsAre;

constexpr double mm = 1e-3;

/// A block of 0.1 m, fixed along x, pressed by 1e5 N/m on a base that moves along x. Stiff blocks, so that
/// the displacement of the joint is that of the base.
class PushedBase {
  public:
    /// Displacement between slip one way and slip the other way, m.
    static constexpr double turn = 2 * 1e5 * std::numbers::inv_sqrt3 / 2e8;

    explicit PushedBase(const dda::CyclicBartonBandis& law) : sim_(scene_of(law)) {
        EXPECT_EQ(sim_.settle().status, dda::RunStatus::completed);
        sim_.on_step = [this](const dda::State& state, const dda::StepReport& report) {
            for (const dda::JointCounterSlip& ended : report.ended_counter_slips)
                so_far.add({state.time, ended});
        };
    }
    void go(double displacement) {
        dda::Stage stage;
        stage.control.step = 1e-3;
        stage.duration = 0.1;
        stage.dynamic_coefficient = 0;
        sim_.velocity(0)[0] = displacement / stage.duration;
        EXPECT_EQ(sim_.run(stage).status, dda::RunStatus::completed);
    }
    CloseReversals at_the_end() const { return with_present(so_far, sim_.model, sim_.state); }
    double time() const { return sim_.state.time; }

    CloseReversals so_far;

  private:
    static Scene scene_of(const dda::CyclicBartonBandis& law) {
        Scene s;
        s.model.gravity.setZero();
        s.model.joint_materials[0].law = law;
        s.model.joint_materials[0].shear_penalty = 1e8;
        s.model.block_materials[0].poissons_ratio = 0;
        s.model.block_materials[0].youngs_modulus = 1e14;
        s.model.fixed_point_penalty = 1e14;
        s.box({-0.1, -0.1}, 0.3, 0.1, dda::Motion::prescribed, 0, "base");
        const int block = s.box({0, 0}, 0.1, 0.1);
        for (const double x : {0.0, 0.1}) {
            s.model.fixed_points.push_back({s.material_point(block, {x, 0}), true, false});
            s.model.loads.push_back(dda::PointLoad{s.material_point(block, {x, 0.1}), {0, -0.5e5}, {}});
        }
        return s;
    }

    Simulation sim_;
};

MATCHER_P3(Slipped, amount, counted, ended, "") {
    // The fixed points give way by the force of the joint over their penalty, 1e-9 m.
    return std::abs(arg.joint.slip.amount - amount) < 1e-8 && arg.joint.slip.counted == counted &&
           arg.ended == ended;
}

// The legs of the path are the slip wanted and the turn before it. Of the slips back and forth 0.05 and 0.3
// mm are near 0.1 mm; 0.01 and 2 mm are not. That of 0.12 mm has no end.
TEST(CloseReversals, AreTheSlipsBackNearMinSlip) {
    PushedBase base(counting_joint());
    const double turn = PushedBase::turn;
    base.go(turn / 2 + 0.5 * mm);
    base.go(-turn - 0.05 * mm);
    EXPECT_THAT(base.so_far.nearest, ElementsAre());
    EXPECT_THAT(base.at_the_end().nearest, ElementsAre(Slipped(0.05 * mm, false, false)));
    base.go(turn + 0.5 * mm);
    EXPECT_THAT(base.so_far.nearest, ElementsAre(Slipped(0.05 * mm, false, true)));
    base.go(-turn - 0.3 * mm);
    base.go(turn + 0.01 * mm);
    EXPECT_THAT(base.so_far.nearest,
                ElementsAre(Slipped(0.05 * mm, false, true), Slipped(0.3 * mm, true, true)));
    base.go(-turn - 2 * mm);
    base.go(turn + 2 * mm);
    const double before = base.time();
    base.go(-turn - 0.12 * mm);
    EXPECT_EQ(base.so_far.counted, 1);
    EXPECT_EQ(base.so_far.not_counted, 1);
    const CloseReversals close = base.at_the_end();
    ASSERT_THAT(close.nearest, ElementsAre(Slipped(0.12 * mm, true, false), Slipped(0.05 * mm, false, true),
                                           Slipped(0.3 * mm, true, true)));
    EXPECT_EQ(close.counted, 2);
    EXPECT_EQ(close.not_counted, 1);
    EXPECT_EQ(close.nearest[0].time, base.time());
    EXPECT_LT(close.nearest[2].time, before);
    const dda::JointCounterSlip& joint = close.nearest[0].joint;
    EXPECT_EQ(joint.first, 0);
    EXPECT_EQ(joint.second, 1);
    EXPECT_EQ(joint.joint_material, 0);
    EXPECT_EQ(joint.slip.least, 0.1 * mm);
    EXPECT_NEAR((joint.at - dda::Vec2(0.05, 0)).norm(), 0, 2e-6)
        << "the middle of the joint, but for the closure of its springs, 1e-6 m";
}

// A slip that has become a reversal goes on in the same direction: it is one counter-slip, not two.
TEST(CloseReversals, CountTheWholeSlipInOneDirection) {
    PushedBase base(counting_joint());
    base.go(PushedBase::turn / 2 + 0.5 * mm);
    base.go(-PushedBase::turn - 0.06 * mm);
    for (int part = 0; part < 3; ++part) base.go(-0.06 * mm);
    EXPECT_THAT(base.at_the_end().nearest, ElementsAre(Slipped(0.24 * mm, true, false)));
    EXPECT_EQ(base.so_far.counted + base.so_far.not_counted, 0);
}

TEST(CloseReversals, OfJointsThatReversalsDoNotWearAreNotListed) {
    dda::CyclicBartonBandis law = counting_joint();
    law.reversal_factor = 1;
    PushedBase base(law);
    base.go(PushedBase::turn / 2 + 0.5 * mm);
    base.go(-PushedBase::turn - 0.05 * mm);
    EXPECT_TRUE(base.at_the_end().nearest.empty());
    dda::Model model;
    model.joint_materials.push_back({"worn by cycles", law});
    EXPECT_FALSE(wears_by_reversals(model));
    model.joint_materials.push_back({"worn by reversals", counting_joint()});
    EXPECT_TRUE(wears_by_reversals(model));
}

// Within a factor of five on either side, the ends included, and no more than twenty, though all are counted.
TEST(CloseReversals, KeepTheNearestByRatio) {
    CloseReversals close;
    const auto add = [&](double ratio, double time) {
        dda::CloseReversal reversal;
        reversal.time = time;
        reversal.joint.slip = CounterSlip{.amount = ratio, .least = 1, .counted = ratio > 1};
        close.add(reversal);
    };
    for (const double ratio : {0.0, 0.19, 5.01}) add(ratio, 0);
    EXPECT_EQ(close.counted + close.not_counted, 0);
    for (const double ratio : {5.0, 0.2}) add(ratio, 0);
    EXPECT_EQ(close.counted, 1);
    EXPECT_EQ(close.not_counted, 1);
    for (int k = 0; k < 40; ++k) add(k % 2 == 0 ? 2 : 0.5, 1 + k);
    EXPECT_EQ(close.counted, 21);
    EXPECT_EQ(close.not_counted, 21);
    ASSERT_EQ(close.nearest.size(), 20U);
    for (int k = 0; k < 20; ++k) EXPECT_EQ(close.nearest[k].time, 1 + k) << "the earliest of equal ratios";
    add(1.1, 100);
    EXPECT_EQ(close.nearest.front().time, 100);
    EXPECT_EQ(close.nearest.size(), 20U);
}

// A least slip of zero counts every slip, and none is close to it.
TEST(CloseReversals, AreNoneWhereEverySlipCounts) {
    dda::CyclicBartonBandis law = counting_joint();
    law.min_slip = 0;
    PushedBase base(law);
    base.go(PushedBase::turn / 2 + 0.5 * mm);
    base.go(-PushedBase::turn - 0.05 * mm);
    EXPECT_EQ(base.at_the_end().counted, 0);
}

}  // namespace
}  // namespace rockslope::close_reversals_test
