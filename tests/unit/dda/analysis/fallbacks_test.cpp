// The report counts the factorisations that are repeated in double precision.

#include <gtest/gtest.h>

#include "dda/analysis/run.hpp"
#include "dda/analysis/step.hpp"
#include "support/walls.hpp"

namespace rockslope::fallbacks_test {
namespace {

/// A step of ten seconds, whose inertia is negligible beside the springs. @param penalty in multiples of E
dda::StepAttempt attempt_with(dda::SolverKind solver, double penalty) {
    scene::Scene s = scene::running_bond_wall(4, 4, penalty);
    s.model.solver = solver;
    dda::Stage stage;
    stage.kind = dda::StageKind::static_equilibrium;
    dda::TimeStepper stepper(s.model, 1);
    return stepper.advance(stage, dda::initial_state(s.model), 10);
}

// With a third of this penalty none falls back. Whether so stiff a step is accepted depends on rounding and
// is not tested.
TEST(Fallbacks, AreCountedWhereSinglePrecisionDoesNotSuffice) {
    const dda::StepReport report = attempt_with(dda::SolverKind::refined, 3e7).report;
    EXPECT_GT(report.fallbacks, 0);
    EXPECT_LE(report.fallbacks, report.factorizations);
}

TEST(Fallbacks, AreZeroWhereSinglePrecisionSuffices) {
    EXPECT_EQ(attempt_with(dda::SolverKind::refined, 100).report.fallbacks, 0);
    EXPECT_EQ(attempt_with(dda::SolverKind::multifrontal, 1e7).report.fallbacks, 0);
}

}  // namespace
}  // namespace rockslope::fallbacks_test
