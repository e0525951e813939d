#include "dda/analysis/step_report.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rockslope::step_report_test {
namespace {

using dda::Contact;
using dda::ContactState;

/// A model with one joint material, whose joints dilate.
dda::Model dilating_joint() {
    dda::Model model;
    dda::BartonBandis law;
    law.damage = 1;
    model.joint_materials.push_back({"joint", law, 0, 0});
    return model;
}

dda::SharedHistory dilated_by(double dilation) {
    dda::BartonBandis::History history;
    history.dilation = dilation;
    return dda::SharedHistory(history);
}

/// The remaining dilation of a contact that is closed at the end of the step.
/// @param by_law dilation of its history at the end; @param solved that of the contact.
double remaining(double by_law, double solved) {
    const std::vector<Contact> start(1);
    std::vector<Contact> end(1);
    const std::vector<dda::EvaluatedContact> evaluated(1);
    end[0].history = dilated_by(by_law);
    end[0].dilation = solved;
    end[0].state = ContactState::sliding;
    return dda::remaining_dilation(dilating_joint(), evaluated, start, end, ThreadPool());
}

TEST(RemainingDilation, IsWhatTheHistoryHasBeyondTheContact) {
    EXPECT_EQ(remaining(0, 0), 0);
    EXPECT_EQ(remaining(.75, .75), 0);
    EXPECT_EQ(remaining(.75, .25), .5) << "postponed";
    EXPECT_EQ(remaining(.25, .75), .5) << "contracting";
    EXPECT_EQ(remaining(-.25, .5), .75) << "solved with too much";
}

TEST(RemainingDilation, IsTheLargestOfClosedOrOverlappingContacts) {
    const dda::Model model = dilating_joint();
    const std::vector<Contact> start(4);
    std::vector<Contact> end(4);
    const std::vector<dda::EvaluatedContact> evaluated(4);
    end[0].state = ContactState::locked;
    end[0].history = dilated_by(.125);
    end[1].dilation = 1;  // open, and has a gap
    end[1].gap = .5;
    EXPECT_EQ(dda::remaining_dilation(model, evaluated, start, end, ThreadPool()), .125);
    end[2].dilation = .25;  // open, and will close by it
    end[2].gap = -.125;
    EXPECT_EQ(dda::remaining_dilation(model, evaluated, start, end, ThreadPool()), .25);
}

}  // namespace
}  // namespace rockslope::step_report_test
