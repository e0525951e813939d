// The direct shear test of Ma et al. (2017), Fig. 4, with blocks: cyclic shear of a joint that wears.

#include <gtest/gtest.h>

#include "dda/joint/shear_step.hpp"
#include "support/record.hpp"
#include "support/shear_box.hpp"

namespace rockslope::cyclic_shear_test {
namespace {

using namespace scene;
using namespace verification;

/// Compares the blocks with the joint law alone, driven through the same displacements under the applied
/// stress.
class Comparison {
  public:
    explicit Comparison(const ShearedRock& rock) : rock_(rock), box_(rock) {
        alone_.history = dda::fresh_history(rock.law, true);
        EXPECT_TRUE(box_.settled());
    }

    void go(double displacement, double increment) {
        const dda::RunOutcome outcome =
            box_.go(displacement, increment, [this](const ShearBox::Reading& now) { compare(now); });
        EXPECT_EQ(outcome.status, dda::RunStatus::completed) << outcome.message;
    }

    double stress() const { return box_.reading().stress; }
    double dilation() const { return box_.reading().dilation; }
    double worst_stress() const { return worst_stress_; }      ///< Pa, off the law
    double worst_dilation() const { return worst_dilation_; }  ///< m
    double frequency_step() const { return box_.frequency_step(); }

  private:
    void compare(const ShearBox::Reading& now) {
        constexpr double length = ShearBox::length;
        const dda::JointLoad load = {rock_.normal_stress * length, length, 2 * rock_.shear_stiffness};
        alone_ = dda::shear(rock_.law, alone_, now.displacement - displacement_, load);
        displacement_ = now.displacement;
        const double expected = dda::dilation(rock_.law, alone_.history);
        worst_dilation_ = std::max(worst_dilation_, std::abs(now.dilation - expected));
        if (std::abs(now.displacement) > rock_.law.peak_displacement / 50)
            worst_stress_ = std::max(worst_stress_, std::abs(now.stress - alone_.shear_force / length));
    }

    ShearedRock rock_;
    ShearBox box_;
    dda::ShearedJoint alone_;
    double displacement_ = 0;  ///< m, of the joint so far
    double worst_stress_ = 0, worst_dilation_ = 0;
};

void expect_two_cycles(const std::string& name, const ShearedRock& rock,
                       const std::vector<joint_tests::QuarterCycle>& expected) {
    Comparison test(rock);
    Case blocks("V37", name + ", two blocks, ±15 mm", "asked for: 0.5 % of the peak, 5 µm");
    const double a = 0.015;
    const std::vector<double> path = {a, -a, -a, a, a, -a, -a, a};
    for (std::size_t k = 0; k < path.size(); ++k) {
        test.go(path[k], rock.law.peak_displacement / 250);
        // The bound jumps at the origin, and the state of the shear spring there depends on the step.
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

// V37. Another test checks the numbers of the law alone; here the blocks must agree with the law at every
// step. The upper block moves by microns along the joint, so the law is driven by the displacement of the
// joint.
TEST(CyclicShearBlocks, Granite) {
    expect_two_cycles("granite", sheared_granite(), joint_tests::granite_quarters);
}

TEST(CyclicShearBlocks, Marble) {
    expect_two_cycles("marble", sheared_marble(), joint_tests::marble_quarters);
}

}  // namespace
}  // namespace rockslope::cyclic_shear_test
