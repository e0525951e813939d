#include "dda/solve/step_matrix.hpp"

#include <gtest/gtest.h>

#include "dda/trial/step_contacts.hpp"
#include "support/first_step.hpp"

namespace rockslope::step_matrix_test {
namespace {

using namespace scene;

// For any change of the active set, the partial reassembly must give the same bits as a full assembly, and
// rows not reported as changed must be unchanged.
TEST(StepMatrix, ReassemblesChangedRowsToTheSameBits) {
    const FirstStep step;
    const dda::StepProblem problem = step.problem();
    dda::StepContacts contacts(problem, step.pool);
    dda::TrialContacts& trials = contacts.trials;
    dda::BlockMatrix work;
    dda::StepMatrix matrix(problem, step.pattern, work, step.pool);
    matrix.assemble(trials);
    EXPECT_TRUE(matrix.changed().empty());
    RandomSource random(5);
    long changed = 0;
    long rows = 0;
    for (const unsigned one_in : {1u, 3u, 10u, 30u, 60u, 60u}) {
        const dda::BlockMatrix last = work;
        const std::vector<Vec6> displacement = moved(random, step.rows.count(), one_in);
        trials.set_displacement(displacement, displacement);
        contacts.entrances.select_first();
        contacts.bounds.update();
        trials.update_active_set();
        matrix.assemble(trials);

        dda::BlockMatrix other_work;
        dda::StepMatrix fresh(problem, step.pattern, other_work, step.pool);
        fresh.assemble(trials);
        EXPECT_EQ(work.diagonal, other_work.diagonal);
        EXPECT_EQ(work.upper, other_work.upper);
        ASSERT_EQ(matrix.changed().size(), work.diagonal.size());
        for (std::size_t r = 0; r < work.diagonal.size(); ++r) {
            changed += matrix.changed()[r];
            ++rows;
            if (matrix.changed()[r] != 0) continue;
            EXPECT_EQ(work.diagonal[r], last.diagonal[r]);
            for (std::uint32_t k = step.pattern.start[r]; k < step.pattern.start[r + 1]; ++k)
                EXPECT_EQ(work.upper[k], last.upper[k]);
        }
    }
    EXPECT_GT(changed, rows / 10);
    EXPECT_LT(changed, rows);
}

}  // namespace
}  // namespace rockslope::step_matrix_test
