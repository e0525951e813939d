// Steps whose matrix is too much for a factor in single precision: taken all the same, counted and told.

#include <gtest/gtest.h>

#include "dda/analysis/run.hpp"
#include "support/walls.hpp"

namespace {

/// A step of ten seconds, in which inertia is as good as nothing beside springs of some million times E.
dda::StepAttempt attempt_with(dda::SolverKind solver, double penalty) {
    scene::Scene s = scene::running_bond_wall(4, 4, penalty);
    s.model.solver = solver;
    dda::Stage stage;
    stage.kind = dda::StageKind::static_equilibrium;
    dda::TimeStepper stepper(s.model, 1);
    return stepper.advance(stage, dda::initial_state(s.model), 10);
}

TEST(Fallbacks, AreCountedWhereSinglePrecisionIsTooLittle) {
    const dda::StepAttempt attempt = attempt_with(dda::SolverKind::refined, 2e6);
    EXPECT_EQ(attempt.rejection, dda::Rejection::none);
    EXPECT_GT(attempt.report.fallbacks, 0);
    EXPECT_LT(attempt.report.fallbacks, attempt.report.factorizations);
}

TEST(Fallbacks, AreNoneWhereItSuffices) {
    EXPECT_EQ(attempt_with(dda::SolverKind::refined, 100).report.fallbacks, 0);
    EXPECT_EQ(attempt_with(dda::SolverKind::multifrontal, 2e6).report.fallbacks, 0);
}

}  // namespace
