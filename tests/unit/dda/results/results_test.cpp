#include "dda/results/results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "dda/checkpoint/state_archive.hpp"
#include "dda/input/read_run.hpp"
#include "dda/monitor/farthest_block.hpp"
#include "dda/results/block_table.hpp"
#include "dda/results/summary.hpp"
#include "dda/writers/frame_data.hpp"
#include "unit/dda/results/run_in_a_folder.hpp"

namespace rockslope::dda::results_test {
namespace {
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

using ResultsTest = RunInAFolder;

TEST_F(ResultsTest, ARunWritesEveryKindOfResult) {
    ASSERT_EQ(simulate("a").status, RunStatus::completed);
    const VtkHdfReader frames(folder / "a" / "run.vtkhdf");
    EXPECT_EQ(frames.frame_count(), 1 + 1 + 10)
        << "the start, the end of the static stage, ten of the dynamic one";
    const GridFrame last = frames.frame(frames.frame_count() - 1, {"displacement", "block", "motion"});
    EXPECT_EQ(last.cells.count(), 2u);
    EXPECT_EQ(last.cells.types[0], 7);
    EXPECT_EQ(last.columns[2], (std::vector<float>{2, 0}));
    EXPECT_GT(std::abs(last.columns[0][3] - last.columns[0][0]), 0.01F) << "the block slides on its base";

    const VtkHdfReader contacts(folder / "a" / "run.joints.vtkhdf");
    EXPECT_EQ(contacts.times(), frames.times());
    const GridFrame settled = contacts.frame(1, {"state", "normal_stress", "normal_force"});
    ASSERT_EQ(settled.cells.count(), 2u) << "two faces have a contact at each end";
    double force = 0, length = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        force += settled.columns[2][i];
        length += settled.columns[2][i] / settled.columns[1][i];
    }
    EXPECT_NEAR(force, 2 * 2500 * 9.81, 0.01 * force) << "the block's weight";
    EXPECT_NEAR(length, 2, 1e-3) << "the joint's length";

    const auto history = lines_of(folder / "a" / "history.csv");
    EXPECT_EQ(history[0],
              "time (s),stage,crest ux (m),crest uy (m),crest vx (m/s),crest vy (m/s),crest ax (m/s2),crest "
              "ay (m/s2),"
              "prescribed base ux (m),prescribed base uy (m),prescribed base vx (m/s),prescribed base vy "
              "(m/s),prescribed base ax (m/s2),prescribed base ay (m/s2)");
    const auto shaken = std::count_if(history.begin(), history.end(), [](const std::string& line) {
        return line.find(",shake,") != std::string::npos;
    });
    EXPECT_EQ(shaken, 1 + 25) << "0.5 s every 0.02 s, and the start with zeroed displacements";
    EXPECT_GT(lines_of(folder / "a" / "steps.csv").size(), 100u);
}

TEST_F(ResultsTest, FramesOfContactsAndTheStepLogMayBeLeftOut) {
    const double whole = estimated_bytes(input.model, input.stages, input.output);
    input.output.joint_frames = input.output.step_log = false;
    EXPECT_LT(estimated_bytes(input.model, input.stages, input.output), 0.7 * whole);
    ASSERT_EQ(simulate("a").status, RunStatus::completed);
    EXPECT_FALSE(fs::exists(folder / "a" / "run.joints.vtkhdf"));
    EXPECT_FALSE(fs::exists(folder / "a" / "steps.csv"));
    EXPECT_TRUE(fs::exists(folder / "a" / "run.vtkhdf"));
}

/// A run with the measured region "all" of its free block.
class ResultsOfABlock : public ResultsTest {
  protected:
    void SetUp() override {
        ResultsTest::SetUp();
        input.model.measured_regions.push_back({"all", {1}});
        fs::create_directories(folder / "a");
        results.emplace(input.model, input.stages, input.output,
                        ResultsOptions{folder / "a", false, "", [](const Progress&) { return true; }});
        state = initial_state(input.model);
        ASSERT_EQ(run(input.model, input.stages, state, *results).status, RunStatus::completed);
        base = state.blocks.centroid(0) - state.centroid_origin[0];
    }

    std::optional<Results> results;
    State state;
    Vec2 base = Vec2::Zero();  ///< displacement of the base
};

TEST_F(ResultsOfABlock, ARegionHasItsDisplacementAndItsPeak) {
    const double moved = (state.blocks.centroid(1) - state.centroid_origin[1] - base).norm();
    const RegionDisplacement end = displacement_of(state, input.model.measured_regions[0], base);
    EXPECT_DOUBLE_EQ(end.mean, moved) << "one block";
    EXPECT_DOUBLE_EQ(end.largest, moved);
    EXPECT_GE(results->state().regions[0].mean, moved);
    EXPECT_GT(results->state().regions[0].mean_time, 0);
}

// The shaken base moves by more than the block slides on it: what counts is the way relative to it.
TEST_F(ResultsOfABlock, TheFarthestBlockCountsFromTheBase) {
    const auto end = farthest_block(input.model, state, base);
    const RegionDisplacement region = displacement_of(state, input.model.measured_regions[0], base);
    EXPECT_EQ(end->block, 1);
    EXPECT_EQ(end->displacement, region.largest);
    EXPECT_GT(farthest_block(input.model, state, Vec2::Zero())->displacement, 2 * region.largest);
    EXPECT_EQ(results->state().farthest->displacement, results->state().regions[0].largest);
    EXPECT_EQ(results->state().farthest->time, results->state().regions[0].largest_time);
}

TEST_F(ResultsTest, TheSameRunWritesTheSameBytes) {
    simulate("a");
    simulate("b");
    expect_same_files("a", "b");
}

TEST_F(ResultsTest, AStageThatFailsLeavesItsLastState) {
    input.stages[0].tolerance = 1e-300;
    input.stages[0].step_limit = 7;
    ASSERT_EQ(simulate("a").status, RunStatus::not_settled);
    const VtkHdfReader frames = frames_of("a");
    ASSERT_EQ(frames.frame_count(), 2) << "the start and the failure";
    const auto log = lines_of(folder / "a" / "steps.csv");
    ASSERT_EQ(log.size(), 1 + 7u) << "the heading and the steps";
    EXPECT_NEAR(frames.times().back(), std::stod(log.back()), 1e-12);
    EXPECT_LT(settlement(frames, 1), -1e-8) << "the block has sunk into its base";
}

TEST_F(ResultsTest, FramesOfStaticStagesAreEstimatedFromTheStepLimit) {
    EXPECT_EQ(max_static_frame_bytes(input.model, input.stages, input.output), 0);
    const double frames = 2 + static_cast<double>(input.stages.size()) - 1 + input.output.frames;
    const double one = estimated_bytes(input.model, input.stages, input.output) / frames;
    input.output.static_frame_interval = 7;
    input.stages[0].step_limit = 100;
    EXPECT_NEAR(max_static_frame_bytes(input.model, input.stages, input.output), 14 * one, 1e-9 * one);
}

TEST_F(ResultsTest, AStaticStageWritesFramesOnRequest) {
    for (const int interval : {1, 2, 3}) {
        const std::string name = "every" + std::to_string(interval);
        input.output.static_frame_interval = interval;
        ASSERT_EQ(simulate(name).status, RunStatus::completed);
        const auto log = lines_of(folder / name / "steps.csv");
        const auto settling = std::count_if(log.begin(), log.end(), [](const std::string& line) {
            return line.find(",settle,") != std::string::npos;
        });
        const std::int64_t inside = (settling - 1) / interval;
        ASSERT_GT(inside, 0);
        const VtkHdfReader frames = frames_of(name);
        EXPECT_EQ(frames.frame_count(), 1 + inside + 1 + 10) << "the last step of a stage has one frame";
        const std::vector<double> times = frames.times();
        EXPECT_TRUE(std::is_sorted(times.begin(), times.end(), std::less_equal<>())) << "no time twice";
        EXPECT_LT(settlement(frames, inside), -1e-8);
        EXPECT_EQ(settlement(frames, inside + 1), 0) << "displacements are zeroed";
        stop_and_resume(name + " stopped", 3);
        expect_same_files(name + " stopped", name);
    }
}

// Displacements are zeroed for the next stage only: the last stage of a run keeps them in its frame.
TEST_F(ResultsTest, ARunThatEndsAtRestReportsItsSettlement) {
    input.stages.pop_back();
    ASSERT_EQ(simulate("a").status, RunStatus::completed);
    const VtkHdfReader frames = frames_of("a");
    ASSERT_EQ(frames.frame_count(), 2);
    EXPECT_LT(settlement(frames, 1), -1e-8);
}

TEST_F(ResultsTest, AKilledRunLeavesReadableResults) {
    fs::create_directories(folder / "killed");
    const pid_t child = ::fork();
    if (child == 0) {
        int step = 0;
        simulate("killed", [&](const Progress& now) {
            if (now.done > 0.25 && ++step == 3) ::kill(::getpid(), SIGKILL);
            return true;
        });
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    for (const char* file : {"run.vtkhdf", "run.joints.vtkhdf"}) {
        const VtkHdfReader frames(folder / "killed" / file);
        EXPECT_EQ(frames.frame_count(), 2 + 5) << file;
        for (std::int64_t k = 0; k < frames.frame_count(); ++k) EXPECT_NO_THROW(frames.frame(k, {}));
    }
    EXPECT_TRUE(read_text_file(folder / "killed" / "steps.csv").ends_with("\n"));
}

TEST_F(ResultsTest, AFullDiskEndsTheRunWithItsResultsSoFar) {
    simulate("whole");
    const auto whole = fs::file_size(folder / "whole" / "run.vtkhdf");
    fs::create_directories(folder / "full");
    const pid_t child = ::fork();
    if (child == 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        // Less than the size of the frames and the space reserved for their metadata.
        const rlimit limit{whole + 200 * 1024, whole + 200 * 1024};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            simulate("full");
        } catch (const OutputError& error) {
            const bool is_reported =
                std::string(error.what()).find("run.vtkhdf: cannot be written: File too large") !=
                std::string::npos;
            ::_exit(is_reported ? 1 : 2);
        }
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
    const VtkHdfReader frames(folder / "full" / "run.vtkhdf");
    EXPECT_GT(frames.frame_count(), 0);
    for (std::int64_t k = 0; k < frames.frame_count(); ++k)
        EXPECT_NO_THROW(frames.frame(k, {"displacement"}));
}

TEST_F(ResultsTest, ValuesThatAreNotFiniteAreNotWritten) {
    fs::create_directories(folder / "nan");
    Results results(input.model, input.stages, input.output,
                    {folder / "nan", false, "", [](const Progress&) { return true; }});
    State state = initial_state(input.model);
    results.stage_begins(input.model, state, input.stages[1], 1);
    const std::string before = read_text_file(folder / "nan" / "history.csv");
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        State broken = state;
        broken.step_count = 7;
        broken.stage_time = 0.1;
        broken.blocks.velocity[1][0] = bad;
        EXPECT_THROW(results.stage_ends(input.model, broken, input.stages[1], 1), OutputError);
    }
    EXPECT_EQ(read_text_file(folder / "nan" / "history.csv"), before);
    EXPECT_EQ(VtkHdfReader(folder / "nan" / "run.vtkhdf").frame_count(), 1);
}

TEST_F(ResultsTest, TheSummaryReportsTheOutcome) {
    fs::create_directories(folder / "a");
    Results results(input.model, input.stages, input.output,
                    {folder / "a", false, "", [](const Progress&) { return true; }});
    State state = initial_state(input.model);
    const RunOutcome outcome = run(input.model, input.stages, state, results);
    const std::string text = summary_text(input.model, input.stages, state, outcome, results,
                                          {.version = "9.9",
                                           .commit = "0a1b2c",
                                           .inputs = input.digests,
                                           .overrides = {"analysis.gravity=[0,-9]"},
                                           .saved_state = InputFile{"settled.h5", "5f"},
                                           .threads = 3,
                                           .kernel = "plain",
                                           .warnings = {"a warning"}});
    for (const char* part :
         {"\"status\": \"completed\"", "\"version\": \"9.9\"", "\"name\": \"crest\"", "\"sha256\": \"",
          "\"sliding\":", "\"fallbacks\": 0,", "\"largest_dilation_left\": 0.0", "\"commit\": \"0a1b2c\"",
          "analysis.gravity=[0,-9]", "\"file\": \"settled.h5\"", "\"threads\": 3", "\"kernel\": \"plain\"",
          "\"same_bytes_on\": ", "\"displacements\": \"one sample", "\"a warning\""})
        EXPECT_THAT(text, HasSubstr(part));
    EXPECT_GT(results.state().peaks[0].displacement, 0.01);
}

TEST_F(ResultsTest, RelativeMotionsAreDifferencesFromTheReference) {
    ASSERT_EQ(simulate("a").status, RunStatus::completed);
    const auto whole = lines_of(folder / "a" / "history.csv");
    const auto relative = lines_of(folder / "a" / "relative.csv");
    ASSERT_EQ(whole.size(), relative.size());
    EXPECT_EQ(relative[0],
              "time (s),stage,crest ux (m),crest uy (m),crest vx (m/s),crest vy (m/s),crest ax (m/s2),crest "
              "ay (m/s2)")
        << "the reference has no columns";
    const auto numbers = [](const std::string& line) {
        std::vector<double> values;
        std::istringstream fields(line);
        std::string field;
        for (int k = 0; std::getline(fields, field, ','); ++k)
            if (k != 1) values.push_back(*parse_number(field));
        return values;
    };
    for (const std::size_t row : {whole.size() / 2, whole.size() - 1}) {
        const auto a = numbers(whole[row]), r = numbers(relative[row]);
        for (std::size_t k = 1; k < r.size(); ++k) EXPECT_EQ(r[k], a[k] - a[k + 6]) << relative[0];
    }
    input.output.relative_to = "";
    ASSERT_EQ(simulate("none").status, RunStatus::completed);
    EXPECT_FALSE(fs::exists(folder / "none" / "relative.csv"));
}

/// Splits a line of a table; its fields hold no commas.
std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream text(line);
    for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
    return fields;
}

// The block slides to and fro on its shaken base: Newmark's estimate is near the slip of the run.
TEST_F(ResultsTest, TheBlockTableReportsTheFinalState) {
    fs::create_directories(folder / "a");
    Results results(input.model, input.stages, input.output,
                    {folder / "a", false, "", [](const Progress&) { return true; }});
    State state = initial_state(input.model);
    ASSERT_EQ(run(input.model, input.stages, state, results).status, RunStatus::completed);
    const auto slips = plane_slips(input.model, input.stages, state, results);
    ASSERT_EQ(slips.size(), 1u);
    const std::string table = block_table(input.model, state, results, slips, "blocks.csv");
    std::istringstream text(table);
    std::string heading, row, rest;
    std::getline(text, heading);
    std::getline(text, row);
    EXPECT_FALSE(std::getline(text, rest)) << "one free block";
    const auto names = fields_of(heading), values = fields_of(row);
    ASSERT_EQ(names.size(), values.size());
    const auto value = [&](const std::string& name) {
        const auto found = std::find(names.begin(), names.end(), name);
        return found == names.end() ? "no " + name : values[found - names.begin()];
    };
    const auto number = [&](const std::string& name) { return *parse_number(value(name)); };
    EXPECT_EQ(value("block"), "1");
    EXPECT_EQ(value("slipped on block"), "0");
    EXPECT_EQ(value("joint material"), "bedding");
    // The base's 60 t m/s2 pass tan 20° g = 3.571 m/s2 at 0.0595 s.
    EXPECT_NEAR(number("first slip (s of shaking)"), 0.0595, 0.005) << "within a step";
    EXPECT_NEAR(number("yield coefficient"), std::tan(20 * M_PI / 180), 1e-6);
    EXPECT_NEAR(number("slip (m)"), number("relative displacement x (m)"), 1e-12);
    EXPECT_NEAR(number("slip (m)"), number("Newmark slip (m)"), 0.03 * std::abs(number("slip (m)")))
        << "steps of 5 ms";
    const std::string printed = outcome_table(input.model, state, results, slips);
    for (const char* part : {"from 'base'", "crest", "1 block slipped, block 1 first", "Newmark's rigid"})
        EXPECT_THAT(printed, HasSubstr(part));
    EXPECT_THAT(printed, Not(HasSubstr("ignores")));
    input.model.fixed_points.push_back({0, true, false});
    const auto held = plane_slips(input.model, input.stages, state, results);
    EXPECT_THAT(outcome_table(input.model, state, results, held),
                HasSubstr("rigid block ignores: fixed points\n"));
    const std::string summary = summary_text(input.model, input.stages, state, {}, results, {});
    EXPECT_THAT(summary, HasSubstr("\"newmark_ignores\": [\n        \"fixed points\""));
}

TEST_F(ResultsTest, TheArchiveKeepsEveryBitOfAState) {
    State state = initial_state(input.model);
    RunObserver silent;
    run(input.model, input.stages, state, silent);
    state.free_fields = {{}, {{Vec2(1, 2)}, {Vec2(3, 4)}, {Vec2(5, 6)}}};
    const StateArchive once = archive(state);
    const State again = restore(once);
    ASSERT_EQ(again.free_fields.size(), 2u);
    EXPECT_TRUE(again.free_fields[0].velocity.empty());
    EXPECT_EQ(again.free_fields[1].displacement, state.free_fields[1].displacement);
    EXPECT_EQ(again.free_fields[1].velocity, state.free_fields[1].velocity);
    EXPECT_EQ(again.free_fields[1].acceleration, state.free_fields[1].acceleration);
    const StateArchive twice = archive(restore(once));
    EXPECT_EQ(once.reals, twice.reals);
    EXPECT_EQ(once.integers, twice.integers);
    EXPECT_EQ(once.bytes, twice.bytes);
    StateArchive cut = once;
    cut.reals.pop_back();
    EXPECT_THROW(restore(cut), std::runtime_error);
    StateArchive longer = once;
    longer.integers.push_back(1);
    EXPECT_THROW(restore(longer), std::runtime_error);
}

TEST(BlockCells, ABlockWithHolesIsOnePolygonOfTheSameArea) {
    Model model;
    model.topology.add_block({4, 4, 3});
    model.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {2, 2}, {2, 4},
                      {4, 4}, {4, 2},  {6, 6},   {6, 8},  {8, 6}};
    const GridCells cells = block_cells(model);
    ASSERT_EQ(cells.count(), 1u);
    EXPECT_EQ(cells.connectivity.size(), 11u + 2 * 2) << "each slit is passed twice";
    double area = 0;
    for (std::size_t i = 0; i < cells.connectivity.size(); ++i) {
        const Vec2& a = model.vertices[cells.connectivity[i]];
        const Vec2& b = model.vertices[cells.connectivity[(i + 1) % cells.connectivity.size()]];
        area += cross(a, b) / 2;
    }
    EXPECT_NEAR(area, 100 - 4 - 2, 1e-12);
}

}  // namespace
}  // namespace rockslope::dda::results_test
