#include "dda/trial/entrance_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/first_step.hpp"

namespace rockslope::entrance_lines_test {
namespace {

using namespace scene;

// Two corners meet. The upper block moves by (1, 2) mm into the other one's corner: the gaps are -1 mm along
// x and -2 mm along y, and the line along x is crossed last.
TEST(EntranceLines, OnlyTheFirstMayClose) {
    Scene s;
    s.box({-1, -1}, 1, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    for (const double inherited : {0.0, 1e-3}) {
        FirstStep step(s.model);
        ASSERT_EQ(step.set.contacts.size(), 2u);
        const int along_x = std::abs(step.set.contacts[0].normal.x()) > 0.5 ? 0 : 1;
        // Twice the inherited penetration counts as gap: now the line along y is crossed last.
        step.found.set.contacts[1 - along_x].inherited_penetration = inherited;
        const dda::StepProblem problem = step.problem();
        dda::TrialContacts trials(problem, step.pool);
        dda::EntranceLines lines(problem, trials);
        const std::vector<Vec6> d{(Vec6() << -1e-3, -2e-3, 0, 0, 0, 0).finished()};
        trials.set_displacement(d, d);
        EXPECT_TRUE(lines.select_first());
        EXPECT_EQ(trials[along_x].may_close, inherited == 0);
        EXPECT_EQ(trials[1 - along_x].may_close, inherited > 0);
        EXPECT_FALSE(lines.select_first()) << "chosen already";
    }
}

}  // namespace
}  // namespace rockslope::entrance_lines_test
