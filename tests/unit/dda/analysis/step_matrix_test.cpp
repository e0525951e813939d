#include "dda/analysis/step_matrix.hpp"

#include <gtest/gtest.h>

#include "support/random_shapes.hpp"
#include "support/step_system.hpp"
#include "support/walls.hpp"

namespace {

using namespace scene;

/// The first step of a wall, as the open-close iteration sees it.
struct FirstStep {
    dda::Crew crew{1};
    dda::Model model = running_bond_wall(8, 8, 10).model;
    dda::RowMap rows{model.motion};
    dda::State state = dda::initial_state(model);
    std::vector<Vec6> still = std::vector<Vec6>(state.blocks.velocity.size(), Vec6::Zero());
    dda::MidStep mid = dda::predict_mid_step(model, state.blocks, still);
    dda::ContactSet set = dda::find_contacts(
        model, state.contacts, {state.blocks.vertices, mid.vertices, {}, 1e-3, 1, 1e-9, 0.005, true}, crew);
    dda::JointFaces faces = dda::JointFaces(model, set.contacts);
    std::vector<dda::ContactSprings> springs =
        dda::contact_springs(model, rows, mid, still, set.contacts, crew);
    std::vector<const dda::JudgedContact*> guess =
        std::vector<const dda::JudgedContact*>(set.contacts.size(), nullptr);
    dda::BaseSystem base;
    dda::StepControl control;
    dda::BlockPattern pattern;

    FirstStep() {
        std::vector<std::pair<int, int>> pairs;
        for (const auto& s : springs) {
            if (s.rows.first >= 0 && s.rows.second >= 0) pairs.emplace_back(s.rows.first, s.rows.second);
        }
        pattern = dda::BlockPattern::from_pairs(rows.count(), std::move(pairs));
        base.stiffness.assign(static_cast<std::size_t>(rows.count()), dda::Mat6::Identity());
        base.load.assign(static_cast<std::size_t>(rows.count()), Vec6::Zero());
    }
    dda::StepProblem problem() const {
        return {model, control, rows,    base, state.blocks, still, set.contacts,
                faces, guess,   springs, {},   {},           1};
    }
};

/// Blocks that go this way by some 0.1 mm, some of them; contacts open and slip.
std::vector<Vec6> moved(Dice& dice, int rows, unsigned one_in) {
    std::vector<Vec6> d(static_cast<std::size_t>(rows), Vec6::Zero());
    for (Vec6& of_row : d) {
        if (dice.one_of(one_in) == 0) of_row.head<2>() = 1e-4 * dice.direction();
    }
    return d;
}

// Whatever opens, closes and slips from one iteration to the next: what is put together in part must be the
// bytes of what is put together at once, and rows that are not told must not differ.
TEST(StepMatrix, OfWhatHasChangedIsTheSameBytesAsAFreshOne) {
    const FirstStep step;
    const dda::StepProblem problem = step.problem();
    dda::TrialContacts trials(problem, step.crew);
    dda::BlockMatrix work;
    dda::StepMatrix matrix(problem, step.pattern, work);
    matrix.assemble(trials);
    EXPECT_TRUE(matrix.changed().empty());
    Dice dice(5);
    long told = 0;
    long rows = 0;
    for (const unsigned one_in : {1u, 3u, 10u, 30u, 60u, 60u}) {
        const dda::BlockMatrix last = work;
        trials.move_to(moved(dice, step.rows.count(), one_in));
        trials.choose_lines();
        trials.update_bounds();
        trials.choose_springs();
        matrix.assemble(trials);

        dda::BlockMatrix other_work;
        dda::StepMatrix fresh(problem, step.pattern, other_work);
        fresh.assemble(trials);
        EXPECT_EQ(work.diagonal, other_work.diagonal);
        EXPECT_EQ(work.upper, other_work.upper);
        ASSERT_EQ(matrix.changed().size(), work.diagonal.size());
        for (std::size_t r = 0; r < work.diagonal.size(); ++r) {
            told += matrix.changed()[r];
            ++rows;
            if (matrix.changed()[r] != 0) continue;
            EXPECT_EQ(work.diagonal[r], last.diagonal[r]);
            for (int k = step.pattern.start[r]; k < step.pattern.start[r + 1]; ++k)
                EXPECT_EQ(work.upper[static_cast<std::size_t>(k)], last.upper[static_cast<std::size_t>(k)]);
        }
    }
    EXPECT_GT(told, rows / 10);
    EXPECT_LT(told, rows);
}

}  // namespace
