#include "dda/analysis/step_report.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rockslope::step_report_test {
namespace {

using dda::Contact;
using dda::ContactState;

/// The remaining dilation of a contact that is closed at the end of the step. Its dilation goes from `before`
/// to `after`, and the step was solved with the increment `solved`.
double remaining(double before, double after, double solved) {
    std::vector<Contact> start(1), end(1);
    std::vector<dda::EvaluatedContact> evaluated(1);
    start[0].dilation = before;
    end[0].dilation = after;
    end[0].state = ContactState::sliding;
    evaluated[0].dilation_increment = solved;
    return dda::remaining_dilation(start, evaluated, end);
}

TEST(RemainingDilation, IsTheDifferenceToTheIncrementOfTheSolution) {
    EXPECT_EQ(remaining(0, 0, 0), 0);
    EXPECT_EQ(remaining(.25, .75, .5), 0);
    EXPECT_EQ(remaining(.25, .75, 0), .5) << "postponed";
    EXPECT_EQ(remaining(.75, .25, 0), .5) << "contracting";
    EXPECT_EQ(remaining(.25, .75, .75), .25) << "solved with too much";
}

TEST(RemainingDilation, IsTheLargestOfClosedOrOverlappingContacts) {
    std::vector<Contact> start(4), end(4);
    const std::vector<dda::EvaluatedContact> evaluated(4);
    end[0].state = ContactState::locked;
    end[0].dilation = .125;
    end[1].dilation = 1;  // open, and has a gap
    end[1].gap = .5;
    EXPECT_EQ(dda::remaining_dilation(start, evaluated, end), .125);
    end[2].dilation = .25;  // open, and will close by it
    end[2].gap = -.125;
    EXPECT_EQ(dda::remaining_dilation(start, evaluated, end), .25);
}

}  // namespace
}  // namespace rockslope::step_report_test
