#include "dda/analysis/counter_slips.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/cyclic_joints.hpp"
#include "support/scene.hpp"

namespace rockslope::counter_slips_test {
namespace {

using dda::Contact;
using joint_tests::counting_joint;

constexpr double mm = 1e-3;

/// The two contacts of one joint segment of the blocks 4 and 2.
struct Segment {
    dda::Model model = scene::Scene().model;
    dda::PerContact<Contact> contacts;

    explicit Segment(const dda::JointLaw& law) {
        model.joint_materials[0].law = law;
        for (const double x : {0.0, 1.0}) {
            Contact& contact = contacts.emplace_back();
            contact.joint_material = 0;
            contact.corner_block = 4;
            contact.edge_block = 2;
            contact.point = {x, 3};
            contact.normal = {0, 1};
            contact.tangent = {-1, 0};
            contact.length = 0.5;
            contact.normal_force = 5e4;
            contact.state = dda::ContactState::sliding;
            contact.history = dda::fresh_history(law, true);
        }
    }
    /// The contacts after a slip of the whole joint, m.
    Segment slipped(double slip) const {
        Segment after = *this;
        const dda::JointLaw& law = model.joint_materials[0].law;
        for (Contact& contact : after.contacts)
            contact.history = dda::advance(law, contact.history, {slip, slip, 1e5, 1, false, 0, 1e15});
        return after;
    }
    auto present() const { return dda::present_counter_slips(model, contacts); }
};

auto ended(const Segment& before, const Segment& after) {
    return dda::ended_counter_slips(before.model, dda::JointSegments(after.model, after.contacts),
                                    before.contacts, after.contacts);
}

TEST(CounterSlips, ArePresentWhileTheJointSlipsAgainstItsDirection) {
    const Segment forward = Segment(counting_joint()).slipped(1 * mm);
    EXPECT_TRUE(forward.present().empty());
    const Segment back = forward.slipped(-0.04 * mm);
    ASSERT_EQ(back.present().size(), 1u) << "one for both contacts";
    const dda::JointCounterSlip slip = back.present()[0];
    EXPECT_EQ(slip.first, 2);
    EXPECT_EQ(slip.second, 4);
    EXPECT_EQ(slip.joint_material, 0);
    EXPECT_EQ(slip.at, dda::Vec2(0.5, 3));
    EXPECT_NEAR(slip.slip.amount, 0.04 * mm, 1e-6 * mm);
    EXPECT_DOUBLE_EQ(slip.slip.least, 0.1 * mm);
    EXPECT_FALSE(slip.slip.counted);
}

TEST(CounterSlips, EndWhereTheJointSlipsOnAsBefore) {
    const Segment back = Segment(counting_joint()).slipped(1 * mm).slipped(-0.04 * mm);
    const auto end = ended(back, back.slipped(0.02 * mm));
    ASSERT_EQ(end.size(), 1u);
    EXPECT_NEAR(end[0].slip.amount, 0.04 * mm, 1e-6 * mm);
    EXPECT_FALSE(end[0].slip.counted);
}

TEST(CounterSlips, GoOnWhileTheyGrowAndWhenTheyBecomeAReversal) {
    const Segment back = Segment(counting_joint()).slipped(1 * mm).slipped(-0.04 * mm);
    EXPECT_TRUE(ended(back, back.slipped(-0.03 * mm)).empty());
    const Segment reversed = back.slipped(-0.2 * mm);
    EXPECT_TRUE(ended(back, reversed).empty());
    ASSERT_EQ(reversed.present().size(), 1u);
    EXPECT_TRUE(reversed.present()[0].slip.counted);
    EXPECT_NEAR(reversed.present()[0].slip.amount, 0.24 * mm, 1e-6 * mm);
}

TEST(CounterSlips, EndAsReversalsWhereTheJointTurnsAgain) {
    const Segment reversed = Segment(counting_joint()).slipped(1 * mm).slipped(-0.24 * mm);
    const auto end = ended(reversed, reversed.slipped(0.05 * mm));
    ASSERT_EQ(end.size(), 1u);
    EXPECT_TRUE(end[0].slip.counted);
    EXPECT_NEAR(end[0].slip.amount, 0.24 * mm, 1e-6 * mm);
}

TEST(CounterSlips, MatterOnlyForJointsThatReversalsWear) {
    EXPECT_TRUE(dda::wears_by_reversals(Segment(counting_joint()).model));
    dda::CyclicBartonBandis kept = counting_joint();
    kept.reversal_factor = 1;
    EXPECT_FALSE(dda::wears_by_reversals(Segment(kept).model));
    EXPECT_FALSE(dda::wears_by_reversals(scene::Scene().model));
}

}  // namespace
}  // namespace rockslope::counter_slips_test
