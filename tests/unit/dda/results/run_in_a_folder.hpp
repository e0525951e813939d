#pragma once

#include <gtest/gtest.h>

#include <sstream>

#include "common/base/read_file.hpp"
#include "dda/analysis/run.hpp"
#include "dda/hdf/vtkhdf_file.hpp"  // IWYU pragma: export
#include "dda/input/read_run.hpp"
#include "dda/results/results.hpp"
#include "dda/writers/frame_data.hpp"  // IWYU pragma: export
#include "unit/dda/input/small_models.hpp"

namespace rockslope::dda {

inline const char* const compared_files[] = {"history.csv", "relative.csv", "joints.csv",
                                             "steps.csv",   "run.vtkhdf",   "run.joints.vtkhdf"};

/// A block that settles on a base and is then shaken until it slides.
class RunInAFolder : public ::testing::Test {
  protected:
    void SetUp() override {
        blockgen::write_block_file(folder / "two.blocks", io_test::two_block_mesh());
        folder.write("run.toml", io_test::two_blocks_with_friction("20 deg") + R"([[measured_joint]]
name = "bed"
at = [2, 1]
[[stage]]
name = "settle"
kind = "static"
[[stage]]
name = "shake"
kind = "dynamic"
duration = 0.5
[stage.base_motion]
block = "base"
x = { times = [0, 0.1, 0.3, 0.5], values = [0, 6, -6, 0] }
[output]
frames = 10
history_interval = 0.02
)");
        input = read_run(folder / "run.toml");
    }

    RunOutcome simulate(
        const std::string& name, ProgressFunction progress = [](const Progress&) { return true; }) {
        std::filesystem::create_directories(folder / name);
        Results results(input.model, input.stages, input.output,
                        {folder / name, pvd, "hash", std::move(progress)});
        State state = initial_state(input.model);
        return run(input.model, input.stages, state, results);
    }
    RunOutcome resume(const std::string& name) {
        const Checkpoint checkpoint = read_checkpoint(folder / name / "checkpoint.h5");
        Results results(input.model, input.stages, input.output,
                        {folder / name, pvd, "hash", [](const Progress&) { return true; }}, &checkpoint);
        State state = checkpoint.state;
        return run(input.model, input.stages, state, results, {1, checkpoint.results.stage, true});
    }
    void expect_same_files(const std::string& a, const std::string& b) {
        for (const char* file : compared_files)
            EXPECT_EQ(read_text_file(folder / a / file), read_text_file(folder / b / file)) << file;
    }
    static std::vector<std::string> lines_of(const std::filesystem::path& path) {
        std::istringstream text(read_text_file(path));
        std::vector<std::string> lines;
        for (std::string line; std::getline(text, line);) lines.push_back(line);
        return lines;
    }

    /// Stops a run at the given step and resumes it from the checkpoint.
    RunOutcome stop_and_resume(const std::string& name, int stop) {
        int step = 0;
        const RunOutcome first = simulate(name, [&](const Progress&) { return ++step < stop; });
        EXPECT_EQ(first.status, RunStatus::stopped) << stop;
        return resume(name);
    }
    VtkHdfReader frames_of(const std::string& name) const {
        return VtkHdfReader(folder / name / "run.vtkhdf");
    }
    /// Vertical displacement of the free block in a frame, m.
    static double settlement(const VtkHdfReader& frames, std::int64_t index) {
        return frames.frame(index, {"displacement"}).columns[0][4];
    }

    io_test::Folder folder;
    RunInput input;
    bool pvd = false;
};

}  // namespace rockslope::dda
