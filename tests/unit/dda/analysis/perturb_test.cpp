#include "dda/analysis/perturb.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::perturb_test {
namespace {

using namespace scene;

struct Perturbed {
    Scene s;
    dda::Stage stage;
    dda::State state;

    explicit Perturbed(std::int64_t seed) {
        s.box({-100, -1}, 300, 1, dda::Motion::prescribed, 0, "base");
        for (int k = 0; k < 50; ++k) s.box({2.0 * k, 0}, 1, 1);
        stage.control.step = 0.01;
        stage.perturbation = seed;
        state = dda::initial_state(s.model);
        dda::perturb(s.model, stage, state);
    }
};

TEST(Perturb, MovesFreeBlocksByTheRoundingOfTheCoordinates) {
    const Perturbed run(3);
    EXPECT_EQ(run.state.blocks.velocity[0], Vec6::Zero()) << "the base moves as prescribed";
    double largest = 0;
    for (int block = 1; block <= 50; ++block) {
        const Vec6& v = run.state.blocks.velocity[block];
        largest = std::max({largest, std::abs(v[0]), std::abs(v[1])});
        EXPECT_EQ(v.tail<4>().norm(), 0);
    }
    const double rounding = 0x1p-52 * 200;
    EXPECT_LE(largest * run.stage.control.step, rounding);
    EXPECT_GT(largest * run.stage.control.step, 0.5 * rounding);
}

TEST(Perturb, HasANewPerturbationForEachSeedAndNoneForZero) {
    EXPECT_EQ(Perturbed(3).state.blocks.velocity, Perturbed(3).state.blocks.velocity);
    EXPECT_NE(Perturbed(3).state.blocks.velocity, Perturbed(4).state.blocks.velocity);
    for (const Vec6& v : Perturbed(0).state.blocks.velocity) EXPECT_EQ(v, Vec6::Zero());
}

}  // namespace
}  // namespace rockslope::perturb_test
