#include "dda/analysis/step_report.hpp"

#include <gtest/gtest.h>

#include <vector>

using namespace rockslope;

namespace {

using dda::Contact;
using dda::ContactState;

/// Of one contact that is closed at the end, from one dilation to another, in a step that was solved with the
/// third.
double left(double before, double after, double solved) {
    std::vector<Contact> start(1), end(1);
    std::vector<dda::EvaluatedContact> evaluated(1);
    start[0].dilation = before;
    end[0].dilation = after;
    end[0].state = ContactState::sliding;
    evaluated[0].dilation_increment = solved;
    return dda::remaining_dilation(start, evaluated, end);
}

TEST(DilationLeft, IsWhatTheStepWasNotSolvedWith) {
    EXPECT_EQ(left(0, 0, 0), 0);
    EXPECT_EQ(left(.25, .75, .5), 0);
    EXPECT_EQ(left(.25, .75, 0), .5) << "postponed";
    EXPECT_EQ(left(.75, .25, 0), .5) << "together";
    EXPECT_EQ(left(.25, .75, .75), .25) << "too much of it";
}

TEST(DilationLeft, IsTheLargestOfWhatBearsOrOverlaps) {
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
