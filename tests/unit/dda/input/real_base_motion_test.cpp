// A base driven by real records: its acceleration is the record, and it ends at rest where it began.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "blockgen/mesh/block_file.hpp"
#include "dda/analysis/run.hpp"
#include "dda/input/read_run.hpp"
#include "support/case_name.hpp"
#include "support/external_data.hpp"
#include "unit/dda/input/small_models.hpp"

namespace rockslope::dda::real_base_motion_test {
namespace {

struct Shaken {
    const char* file;
    const char* keys;  ///< additional keys of the axis
};

class RealBaseMotion : public ::testing::TestWithParam<Shaken> {};

/// Compares the acceleration of the base with its table at the end of every step.
class BaseMonitor : public RunObserver {
  public:
    explicit BaseMonitor(const TimeTable& table) : table_(table) {}
    bool step_done(const Model&, const State& state, const Stage& stage, const StepReport& report) override {
        if (stage.is_static()) return true;
        const double t = state.stage_time;
        const double a = t > table_.times().back() ? 0 : table_.at(t);
        worst = std::max(worst, std::abs(state.blocks.acceleration[0][0] - a));
        cuts += report.cuts;
        largest_velocity = std::max(largest_velocity, std::abs(state.blocks.velocity[0][0]));
        largest_displacement = std::max(largest_displacement, std::abs(state.blocks.centroid(0).x() - start));
        return true;
    }
    double start = 0;
    double worst = 0;  ///< m/s2
    double largest_velocity = 0, largest_displacement = 0;
    int cuts = 0;

  private:
    const TimeTable& table_;
};

// Required: 1e-6 of the peak, also with cut steps, which the fast sliding block causes here. The remaining
// drift is the rounding of 16000 sums of 1e-16 each.
TEST_P(RealBaseMotion, IsTheRecordAndEndsAtRest) {
    const auto folder = external_data("records");
    if (!folder) GTEST_SKIP() << external_data_missing("records");
    const io_test::Folder own;
    blockgen::write_block_file(own / "two.blocks", io_test::two_block_mesh());
    const auto file = (*folder / GetParam().file).string();
    const RunInput input = read_run(own.write("run.toml", io_test::two_blocks_with_friction("60 deg") +
                                                              R"([[stage]]
kind = "static"
[[stage]]
kind = "dynamic"
duration = 45
step = "5 ms"
displacement_ratio = 1e-3
[stage.base_motion]
x = { file = ")" + file + R"(", baseline = "drift")" + GetParam().keys +
                                                              R"( }
)"));
    const TimeTable& table = input.stages[1].base_motions.at(0).x;
    double peak = 0;
    for (const double a : table.values()) peak = std::max(peak, std::abs(a));
    State state = initial_state(input.model);
    BaseMonitor monitor(table);
    monitor.start = state.blocks.centroid(0).x();
    const RunOutcome outcome = run(input.model, input.stages, state, monitor);
    ASSERT_EQ(outcome.status, RunStatus::completed) << outcome.message;
    EXPECT_GT(monitor.cuts, 0) << "the case must have cut steps";
    EXPECT_LT(monitor.worst, 1e-6 * peak);
    EXPECT_LT(std::abs(state.blocks.velocity[0][0]), 1e-9 * monitor.largest_velocity);
    EXPECT_LT(std::abs(state.blocks.centroid(0).x() - monitor.start), 1e-8 * monitor.largest_displacement);
}

INSTANTIATE_TEST_SUITE_P(Records, RealBaseMotion,
                         ::testing::Values(Shaken{"RSN763_LOMAP_GIL067.AT2", ""}, Shaken{"IELC180.AT2", ""},
                                           Shaken{"NIS090.AT2", ""}),
                         [](const auto& tested) { return case_name(tested.param.file); });

}  // namespace
}  // namespace rockslope::dda::real_base_motion_test
