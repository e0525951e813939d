// Steps whose matrix is too much for a factor in single precision: what falls back is counted and told.

#include <gtest/gtest.h>

#include "dda/analysis/run.hpp"
#include "support/walls.hpp"

using namespace rockslope;

namespace {

/// A step of ten seconds, in which inertia is as good as nothing beside springs of ten million times E.
dda::StepAttempt attempt_with(dda::SolverKind solver, double penalty) {
    scene::Scene s = scene::running_bond_wall(4, 4, penalty);
    s.model.solver = solver;
    dda::Stage stage;
    stage.kind = dda::StageKind::static_equilibrium;
    dda::TimeStepper stepper(s.model, 1);
    return stepper.advance(stage, dda::initial_state(s.model), 10);
}

// The first factors fall back at a tenth of these springs. Whether so stiff a step is taken in the end hangs
// on the last digits, and is not asked for.
TEST(Fallbacks, AreCountedWhereSinglePrecisionIsTooLittle) {
    const dda::StepReport report = attempt_with(dda::SolverKind::refined, 1e7).report;
    EXPECT_GT(report.fallbacks, 0);
    EXPECT_LE(report.fallbacks, report.factorizations);
}

TEST(Fallbacks, AreNoneWhereItSuffices) {
    EXPECT_EQ(attempt_with(dda::SolverKind::refined, 100).report.fallbacks, 0);
    EXPECT_EQ(attempt_with(dda::SolverKind::multifrontal, 1e7).report.fallbacks, 0);
}

}  // namespace
