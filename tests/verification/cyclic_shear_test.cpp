// The direct shear test of Ma et al. (2017), Fig. 4, as blocks: a joint that is sheared to and fro and wears.

#include <gtest/gtest.h>

#include "dda/joint/shear_step.hpp"
#include "support/cyclic_joints.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace {

using namespace scene;
using namespace verification;

struct Rock {
    dda::CyclicBartonBandis law;
    double normal_stress;    ///< Pa
    double strength;         ///< Pa, at the peak
    double shear_stiffness;  ///< N/m per metre, of one of the joint's two contacts
};
Rock granite() {
    return {joint_tests::granite(), 1e6, 1.92024e6, 7.681e7};
}
Rock marble() {
    return {joint_tests::marble(), 0.5e6, 1.13060e6, 1.884e8};
}

constexpr double length = 0.1;  ///< m, of the joint

/// The upper block, 0.1 m wide, is held along the joint at its lower corners and loaded across it; the lower
/// one, wide enough for the joint to keep its length, moves.
struct ShearBox {
    Scene scene;
    int lower, upper, corner;

    explicit ShearBox(const Rock& rock) {
        scene.model.gravity.setZero();
        scene.model.joint_materials[0].law = rock.law;
        scene.model.joint_materials[0].shear_penalty = rock.shear_stiffness;
        scene.model.block_materials[0].poissons_ratio = 0;
        lower = scene.box({-0.1, -0.1}, 0.3, 0.1, dda::Motion::prescribed, 0, "lower");
        upper = scene.box({0, 0}, length, length);
        corner = 4;
        const double share = rock.normal_stress * length / 2;
        for (const double x : {0.0, length}) {
            scene.model.fixed_points.push_back({scene.material_point(upper, {x, 0}), true, false});
            scene.model.loads.push_back(
                dda::PointLoad{scene.material_point(upper, {x, length}), {0, -share}, {}});
        }
    }
};

/// The test beside the law by itself, which goes through the same displacements under the stress applied.
class Comparison {
  public:
    explicit Comparison(const Rock& rock) : rock_(rock), box_(rock), sim_(box_.scene) {
        alone_.history = dda::fresh_history(rock.law, true);
        EXPECT_EQ(sim_.settle().status, dda::RunStatus::completed);
        height_ = top();
        sim_.each_step = [this](const dda::State&, const dda::StepReport&) { compare(); };
    }

    void go(double displacement, double increment) {
        dda::Stage stage;
        stage.name = "shear";
        stage.control.step = 1e-3;
        stage.duration = std::abs(displacement) / increment * stage.control.step;
        stage.dynamic_coefficient = 0;
        sim_.velocity(box_.lower)[0] = std::copysign(increment / stage.control.step, displacement);
        const dda::RunOutcome outcome = sim_.run(stage);
        EXPECT_EQ(outcome.status, dda::RunStatus::completed) << outcome.message;
    }

    double stress() const {
        double force = 0;
        for (const dda::Contact& contact : sim_.state.contacts.contacts) force += contact.shear_force;
        return force / length;
    }
    double dilation() const { return top() - height_; }
    double worst_stress() const { return worst_stress_; }      ///< Pa, off the law
    double worst_dilation() const { return worst_dilation_; }  ///< m
    double frequency_step() const { return sim_.contact_frequency_step(); }

  private:
    double top() const { return sim_.state.blocks.vertices[static_cast<std::size_t>(box_.corner)].y(); }

    void compare() {
        const double now = sim_.moved(box_.lower).x() -
                           sim_.state.blocks.vertices[static_cast<std::size_t>(box_.corner)].x();
        const dda::JointLoad load = {rock_.normal_stress * length, length, 2 * rock_.shear_stiffness};
        alone_ = dda::shear(rock_.law, alone_, now - displacement_, load);
        displacement_ = now;
        const double expected = dda::dilation(rock_.law, alone_.history);
        worst_dilation_ = std::max(worst_dilation_, std::abs(dilation() - expected));
        if (std::abs(now) > rock_.law.peak_displacement / 50)
            worst_stress_ = std::max(worst_stress_, std::abs(stress() - alone_.shear_force / length));
    }

    Rock rock_;
    ShearBox box_;
    Simulation sim_;
    dda::ShearedJoint alone_;
    double displacement_ = 0;  ///< m, of the joint so far
    double height_ = 0;        ///< m, of the upper block's corner before the shearing
    double worst_stress_ = 0, worst_dilation_ = 0;
};

void expect_two_cycles(const std::string& name, const Rock& rock,
                       const std::vector<joint_tests::Quarter>& expected) {
    Comparison test(rock);
    Case blocks("V37", name + ", two blocks, ±15 mm", "asked for: 0.5 % of the peak, 5 µm");
    const double a = 0.015;
    const std::vector<double> path = {a, -a, -a, a, a, -a, -a, a};
    for (std::size_t k = 0; k < path.size(); ++k) {
        test.go(path[k], rock.law.peak_displacement / 250);
        // At the origin the bound jumps, and the spring has begun to climb or has not.
        const std::string at = " after quarter " + std::to_string(k + 1);
        if (k % 2 == 0)
            blocks.expect("stress" + at, "MPa", test.stress() / 1e6, expected[k].stress,
                          absolute(5e-3 * rock.strength / 1e6));
        blocks.expect("dilation" + at, "mm", test.dilation() * 1e3, expected[k].dilation, absolute(5e-3));
    }
    blocks.contact_frequency_step(test.frequency_step());
    blocks.expect_below("stress off the law, of its peak", "", test.worst_stress() / rock.strength, 5e-3);
    blocks.expect_below("dilation off the law", "mm", test.worst_dilation() * 1e3, 5e-3);
}

// V37. The law's own numbers are asserted beside those of the law alone; here the blocks must follow them at
// every step. The upper block gives way by microns along the joint: the law goes where the joint went.
TEST(CyclicShearBlocks, Granite) {
    expect_two_cycles("granite", granite(), joint_tests::granite_quarters);
}

TEST(CyclicShearBlocks, Marble) {
    expect_two_cycles("marble", marble(), joint_tests::marble_quarters);
}

}  // namespace
