#include "dda/analysis/model_scale.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/scene.hpp"

namespace rockslope::model_scale_test {
namespace {

using namespace scene;

TEST(ModelScale, MeasuresTheModelAsItStands) {
    Scene s;
    s.box({-4, -1}, 8, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    s.box({2, 0}, 1, 3);
    const dda::RowMap rows(s.model.motion);
    const dda::ModelScale scale(s.model, rows);
    EXPECT_DOUBLE_EQ(scale.half_height, 2);
    EXPECT_DOUBLE_EQ(scale.mean_weight, 2 * 2500 * g) << "of the two blocks with unknowns, 1 m2 and 3 m2";
    EXPECT_DOUBLE_EQ(scale.edge_length, 1);
    EXPECT_DOUBLE_EQ(scale.coordinate_rounding, 8 * 4 * std::numeric_limits<double>::epsilon());
    dda::StepControl control;
    control.displacement_ratio = 0.01;
    EXPECT_DOUBLE_EQ(scale.displacement_limit(control), 0.02);
}

TEST(ModelScale, IsWithoutWeightWhereNoBlockMoves) {
    Scene s;
    s.box({0, 0}, 1, 1, dda::Motion::fixed);
    EXPECT_EQ(dda::ModelScale(s.model, dda::RowMap(s.model.motion)).mean_weight, 0);
}

}  // namespace
}  // namespace rockslope::model_scale_test
