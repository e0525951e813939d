#include "dda/analysis/step_report.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using dda::Contact;
using dda::ContactState;

/// Of one contact that is closed at the end, from one dilation to another, in a step that was solved with the
/// third.
double left(double before, double after, double solved) {
    std::vector<Contact> start(1), end(1);
    std::vector<dda::JudgedContact> judged(1);
    start[0].dilation = before;
    end[0].dilation = after;
    end[0].state = ContactState::sliding;
    judged[0].dilating = solved;
    return dda::dilation_left(start, judged, end);
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
    const std::vector<dda::JudgedContact> judged(4);
    end[0].state = ContactState::locked;
    end[0].dilation = .125;
    end[1].dilation = 1;  // open, and has a gap
    end[1].gap = .5;
    EXPECT_EQ(dda::dilation_left(start, judged, end), .125);
    end[2].dilation = .25;  // open, and will close by it
    end[2].gap = -.125;
    EXPECT_EQ(dda::dilation_left(start, judged, end), .25);
}

}  // namespace
