#include "dda/analysis/step_equations.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::step_equations_test {
namespace {

using namespace scene;

/// A block of 1 m on a fixed base, that moves at 2 m/s along it.
struct SlidingStep {
    Scene s;
    dda::Stage stage;
    ThreadPool pool{1};
    dda::RowContacts row_contacts;

    SlidingStep() {
        s.box({-2, -1}, 6, 1, dda::Motion::fixed);
        s.box({0, 0}, 1, 1);
        stage.control.step = 0.01;
    }
    template <class Use>
    void with_equations(const Use& use) {
        const dda::RowMap rows(s.model.motion);
        const dda::ModelScale scale(s.model, rows);
        const dda::StepSetting setting{s.model, rows, scale, pool};
        dda::State state = dda::initial_state(s.model);
        state.blocks.velocity[1][0] = 2;
        state.dynamic_time = 3;
        const dda::Prediction prediction = dda::initial_prediction(setting, stage, state, 0.005);
        const dda::StepEquations step =
            dda::step_equations(setting, stage, state, 0.005, prediction, row_contacts);
        use(prediction, step, dda::step_problem(setting, stage, state, step, row_contacts));
    }
};

TEST(StepEquations, PredictWhatTheVelocitiesDo) {
    SlidingStep sliding;
    sliding.with_equations([](const dda::Prediction& prediction, const auto& step, const auto&) {
        EXPECT_DOUBLE_EQ(prediction.predicted[1][0], 0.01);
        EXPECT_GT(prediction.search_radius.largest(), 0.01);
        EXPECT_NEAR(step.mid.vertices[4].x(), 0.005, 1e-15) << "half-way";
    });
}

TEST(StepEquations, HaveTheWeightAsTheirLoadAndInertia) {
    SlidingStep sliding;
    sliding.with_equations([](const auto&, const dda::StepEquations& step, const dda::StepProblem& problem) {
        ASSERT_EQ(step.base.load.size(), 1u);
        EXPECT_DOUBLE_EQ(step.base.load[0][1], -2500 * g);
        // Newmark's beta is 1/2: 2 M / dt^2 of the displacement, and 2 M v / dt of the velocity.
        EXPECT_NEAR(step.base.stiffness[0](0, 0), 2 * 2500 / (0.005 * 0.005), 1e-3);
        EXPECT_NEAR(step.base.load[0][0], 2 * 2500 * 2 / 0.005, 1e-6);
        EXPECT_EQ(problem.base.load.data(), step.base.load.data());
    });
}

TEST(StepEquations, TakeTimeInDynamicStagesAlone) {
    SlidingStep sliding;
    sliding.with_equations([](const auto&, const dda::StepEquations& step, const dda::StepProblem& problem) {
        EXPECT_DOUBLE_EQ(problem.time.duration(), 0.005);
        EXPECT_FALSE(problem.time.is_static());
        EXPECT_DOUBLE_EQ(step.loads.time, 3.005);
    });
    sliding.stage.kind = dda::StageKind::static_equilibrium;
    sliding.with_equations([](const auto&, const dda::StepEquations& step, const dda::StepProblem& problem) {
        EXPECT_EQ(problem.time.duration(), 0);
        EXPECT_TRUE(problem.time.is_static());
        EXPECT_DOUBLE_EQ(step.loads.time, 3);
        EXPECT_TRUE(step.dashpots.empty());
    });
}

TEST(StepEquations, ListTheContactsOfTheRows) {
    SlidingStep sliding;
    sliding.with_equations([&](const auto&, const dda::StepEquations& step, const dda::StepProblem& problem) {
        ASSERT_FALSE(step.contacts.contacts.empty());
        EXPECT_EQ(sliding.row_contacts.of(dda::RowIndex(0)).size(), step.contacts.contacts.size());
        EXPECT_EQ(&problem.row_contacts, &sliding.row_contacts);
    });
}

}  // namespace
}  // namespace rockslope::step_equations_test
