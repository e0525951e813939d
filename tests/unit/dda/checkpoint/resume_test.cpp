// Runs that are stopped and resumed from their checkpoint.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "dda/analysis/step.hpp"
#include "dda/checkpoint/resume_check.hpp"
#include "dda/checkpoint/state_archive.hpp"
#include "dda/results/block_table.hpp"
#include "dda/results/summary.hpp"
#include "support/walls.hpp"
#include "unit/dda/results/run_in_a_folder.hpp"

namespace rockslope::dda::resume_test {
namespace {
namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ContinuedRun : public RunInAFolder {
  protected:
    /// What a run leaves in memory.
    struct Ended {
        State state;
        std::unique_ptr<Results> results;
        RunOutcome outcome;
    };
    /// Runs the input into the folder `name`. A run that is stopped after `stop` steps is resumed.
    Ended ended(const std::string& name, int stop) const {
        fs::create_directories(folder / name);
        int step = 0;
        const ProgressFunction progress = [&](const Progress&) { return ++step < stop; };
        Ended end{initial_state(input.model),
                  std::make_unique<Results>(input.model, input.stages, input.output,
                                            ResultsOptions{folder / name, false, "hash", progress}),
                  {}};
        end.outcome = run(input.model, input.stages, end.state, *end.results);
        if (end.outcome.status != RunStatus::stopped) return end;
        const Checkpoint checkpoint = read_checkpoint(folder / name / "checkpoint.h5");
        end.results = std::make_unique<Results>(
            input.model, input.stages, input.output,
            ResultsOptions{folder / name, false, "hash", [](const Progress&) { return true; }}, &checkpoint);
        end.state = checkpoint.state;
        end.outcome =
            run(input.model, input.stages, end.state, *end.results, {1, checkpoint.results.stage, true});
        return end;
    }
};

TEST_F(ContinuedRun, EndsInTheSameBytes) {
    simulate("whole");
    // Stop in the static stage, early and late in the dynamic one, and in the last step.
    const auto steps = static_cast<int>(lines_of(folder / "whole" / "steps.csv").size()) - 1;
    for (const int stop : {1, steps / 2, steps - 20, steps}) {
        const std::string name = "stopped" + std::to_string(stop);
        EXPECT_EQ(stop_and_resume(name, stop).status, RunStatus::completed) << stop;
        expect_same_files(name, "whole");
    }
}

/// A run that went on after its checkpoint and was killed: it has later frames, rows and files of frames.
class KilledRun : public ContinuedRun {
  protected:
    void SetUp() override {
        ContinuedRun::SetUp();
        pvd = true;
        simulate("whole");
        steps = static_cast<int>(lines_of(folder / "whole" / "steps.csv").size()) - 1;
        int step = 0;
        simulate("killed", [&](const Progress&) { return ++step < steps / 3; });
        ASSERT_LT(frames_of("killed").frame_count(), frames_of("whole").frame_count() - 1);
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / "whole"))
            if (entry.path().filename() != "checkpoint.h5")
                fs::copy_file(entry.path(), folder / "killed" / entry.path().filename(),
                              fs::copy_options::overwrite_existing);
    }
    /// Resumes the run and stops it after some steps.
    RunStatus resume_for(int steps_until_stop) {
        const Checkpoint checkpoint = read_checkpoint(folder / "killed" / "checkpoint.h5");
        int done = 0;
        Results results(
            input.model, input.stages, input.output,
            {folder / "killed", pvd, "hash", [&](const Progress&) { return ++done < steps_until_stop; }},
            &checkpoint);
        State state = checkpoint.state;
        begins();
        return run(input.model, input.stages, state, results, {1, checkpoint.results.stage, true}).status;
    }
    /// The files of the whole run that the killed one does not have with the same bytes.
    std::vector<std::string> different() const {
        std::vector<std::string> files;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / "whole")) {
            const fs::path name = entry.path().filename();
            if (name != "checkpoint.h5" &&
                read_text_file(entry.path()) != read_text_file(folder / "killed" / name))
                files.push_back(name.string());
        }
        return files;
    }
    bool has_temporary_files() const {
        return std::any_of(fs::directory_iterator(folder / "killed"), fs::directory_iterator(),
                           [](const auto& entry) {
                               return entry.path().filename().string().find(".tmp") != std::string::npos;
                           });
    }

    int steps = 0;
    std::function<void()> begins = [] {};
};

// Tables and the list of files were cut back at once, so that a second kill lost what the first had left.
TEST_F(KilledRun, KeepsWhatItHadUntilItIsWrittenAgain) {
    begins = [&] { EXPECT_THAT(different(), ElementsAre()) << "at the start"; };
    EXPECT_EQ(resume_for(steps / 3), RunStatus::stopped);
    EXPECT_THAT(different(), ElementsAre()) << "after a resumed run that was stopped early";
    EXPECT_FALSE(has_temporary_files());
    EXPECT_EQ(resume_for(steps), RunStatus::completed);
    EXPECT_THAT(different(), ElementsAre());
}

// The name of the copy of the frames was run.vtkhdf.resumed.
TEST_F(KilledRun, FollowsNoLinkAtTheSideOfItsFrames) {
    folder.write("killed/victim", "precious");
    fs::create_symlink("victim", folder / "killed" / "run.vtkhdf.resumed");
    EXPECT_EQ(resume_for(steps), RunStatus::completed);
    EXPECT_EQ(read_text_file(folder / "killed" / "victim"), "precious");
    EXPECT_THAT(different(), ElementsAre());
}

// Rows that a power cut spoilt, or that another version of the program wrote.
TEST_F(KilledRun, ReplacesOtherRowsAndFrames) {
    for (const char* file : {"history.csv", "steps.csv", "joints.csv"}) {
        std::string text = read_text_file(folder / "killed" / file);
        text[text.size() - 40] = '?';
        folder.write("killed/" + std::string(file), text + "1,more,rows\n2,hal");
    }
    std::string list = read_text_file(folder / "killed" / "run.pvd");
    list.insert(list.find("</Collection>"), "<DataSet timestep=\"9\" file=\"run.99.vtu\"/>\n");
    folder.write("killed/run.pvd", list);
    EXPECT_EQ(resume_for(steps), RunStatus::completed);
    EXPECT_THAT(different(), ElementsAre());
}

// A changed number in a row or a frame went on into the results of the resumed run.
TEST_F(KilledRun, IsRefusedWhereItsResultsAreNotThoseThatItWrote) {
    const Checkpoint checkpoint = read_checkpoint(folder / "killed" / "checkpoint.h5");
    const auto error = [&] {
        return io_test::error_of([&] {
            check_resumable(checkpoint, writer_context(input.model, folder / "killed", input.output, pvd));
        });
    };
    EXPECT_EQ(error(), "no error");
    for (const char* file : {"history.csv", "steps.csv", "joints.csv", "run.1.vtu", "run.joints.1.vtu"}) {
        const std::string whole = read_text_file(folder / "killed" / file);
        std::string damaged = whole;
        damaged[damaged.size() / 50] ^= 1;
        folder.write("killed/" + std::string(file), damaged);
        EXPECT_THAT(error(), HasSubstr("cannot be resumed from: it is damaged")) << file;
        folder.write("killed/" + std::string(file), whole);
    }
    input.model.gravity *= 1.001;
    simulate("other");
    for (const char* file : {"run.vtkhdf", "run.joints.vtkhdf"}) {
        fs::copy_file(folder / "other" / file, folder / "killed" / file,
                      fs::copy_options::overwrite_existing);
        EXPECT_THAT(error(), HasSubstr("cannot be resumed from: it is damaged")) << file;
        fs::copy_file(folder / "whole" / file, folder / "killed" / file,
                      fs::copy_options::overwrite_existing);
    }
    EXPECT_EQ(error(), "no error");
}

TEST_F(ContinuedRun, RestoresExcavatedBlocks) {
    blockgen::BlockMesh mesh = io_test::two_block_mesh();
    const blockgen::VertexIndex first = mesh.vertices.size();
    mesh.vertices.insert(mesh.vertices.end(), {{.1, 1}, {.9, 1}, {.9, 1.5}, {.1, 1.5}});
    mesh.begin_block(0);
    mesh.add_ring(std::vector<blockgen::VertexIndex>{first, first + 1, first + 2, first + 3},
                  std::vector<blockgen::EdgeMark>(4));
    mesh.excavations = {{"bench", 2, {2}}};
    blockgen::write_block_file(folder / "two.blocks", mesh);
    input = read_run(folder / "run.toml");
    ASSERT_EQ(input.model.excavations.size(), 1u);
    simulate("whole");
    const VtkHdfReader frames = frames_of("whole");
    const auto blocks_in = [&](std::int64_t k) { return frames.frame(k, {"block"}).columns[0].size(); };
    EXPECT_EQ(blocks_in(0), 3u) << "before the excavation";
    EXPECT_EQ(blocks_in(frames.frame_count() - 1), 2u) << "removed at the start of the dynamic stage";
    // Stop before, right after and long after the excavation, and in the last step.
    const auto lines = lines_of(folder / "whole" / "steps.csv");
    const auto settled = static_cast<int>(std::count_if(
        lines.begin(), lines.end(), [](const auto& l) { return l.find("settle") != std::string::npos; }));
    const auto steps = static_cast<int>(lines.size()) - 1;
    ASSERT_GT(settled, 1);
    ASSERT_GT(steps, settled + 2);
    for (const int stop : {1, settled, settled + 1, (settled + steps) / 2, steps}) {
        const std::string name = "stopped" + std::to_string(stop);
        EXPECT_EQ(stop_and_resume(name, stop).status, RunStatus::completed) << stop;
        expect_same_files(name, "whole");
    }
}

TEST_F(ContinuedRun, ContinuesTheCountToTheStepLimit) {
    input.stages[0].tolerance = 1e-300;
    input.stages[0].step_limit = 40;
    const RunOutcome whole = simulate("whole");
    ASSERT_EQ(whole.status, RunStatus::not_settled);
    ASSERT_EQ(lines_of(folder / "whole" / "steps.csv").size(), 1 + 40u);
    for (const int stop : {1, 25, 39}) {
        const std::string name = "stopped" + std::to_string(stop);
        const RunOutcome outcome = stop_and_resume(name, stop);
        EXPECT_EQ(outcome.status, RunStatus::not_settled) << stop;
        EXPECT_EQ(outcome.message, whole.message) << stop;
        expect_same_files(name, "whole");
    }
    // A stop in the last step of the limit has nothing to resume.
    int step = 0;
    EXPECT_EQ(simulate("late", [&](const Progress&) { return ++step < 40; }).status, RunStatus::not_settled);
}

TEST_F(ContinuedRun, ListsEveryFrameOnceForOlderParaView) {
    pvd = true;
    simulate("whole");
    const auto steps = static_cast<int>(lines_of(folder / "whole" / "steps.csv").size()) - 1;
    EXPECT_EQ(stop_and_resume("stopped", steps / 2).status, RunStatus::completed);
    const std::string list = read_text_file(folder / "stopped" / "run.pvd");
    EXPECT_EQ(list, read_text_file(folder / "whole" / "run.pvd"));
    const std::vector<double> times = frames_of("stopped").times();
    std::size_t at = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
        const std::string file = "run." + std::to_string(k) + ".vtu";
        const std::string entry = "timestep=\"" + shortest_text(times[k]) + "\" file=\"" + file + "\"";
        at = list.find(entry, at);
        ASSERT_NE(at, std::string::npos) << entry << " is missing or out of order";
        EXPECT_EQ(read_text_file(folder / "stopped" / file), read_text_file(folder / "whole" / file));
    }
    EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), static_cast<long>(times.size()) + 5);
}

TEST_F(ContinuedRun, RestoresFirstSlips) {
    const auto table_of = [&](const std::string& name, int stop) {
        const Ended end = ended(name, stop);
        return block_table(input.model, end.state, *end.results,
                           plane_slips(input.model, input.stages, end.state, *end.results), "blocks.csv");
    };
    const std::string whole = table_of("whole", 1'000'000);
    const auto steps = static_cast<int>(lines_of(folder / "whole" / "steps.csv").size()) - 1;
    EXPECT_EQ(table_of("stopped", steps - 30), whole);
}

// A joint that dilates as it is sheared. The checkpoint has the largest remaining dilation of the step log.
TEST_F(ContinuedRun, RestoresTheLargestRemainingDilation) {
    CyclicBartonBandis law;
    law.barton = {8, 100e6, .3};
    law.peak_displacement = 5e-3;
    law.damage = 1;
    law.reversal_factor = .95;
    const RoughnessTable wear = {{{0, 1}, {1, 1}, {2, .9}, {4, .7}}};
    law.cycles = {{wear, wear, wear, wear}};
    input.model.gravity = 9.81 * Vec2(std::sin(.6), -std::cos(.6));
    for (JointMaterial& material : input.model.joint_materials) {
        material.law = law;
        material.shear_penalty = input.model.normal_penalty;
    }
    int step = 0;
    ASSERT_EQ(simulate("a", [&](const Progress&) { return ++step < 80; }).status, RunStatus::stopped);

    const auto cell = [](const std::string& line, int column) {
        std::istringstream cells(line);
        std::string text;
        for (int k = 0; k <= column; ++k) std::getline(cells, text, ',');
        return text;
    };
    const auto log = lines_of(folder / "a" / "steps.csv");
    int column = 0;
    while (cell(log[0], column) != "dilation left (m)") ++column;
    double largest = 0;
    for (std::size_t k = 1; k < log.size(); ++k) largest = std::max(largest, std::stod(cell(log[k], column)));
    EXPECT_GT(largest, 0);
    EXPECT_EQ(read_checkpoint(folder / "a" / "checkpoint.h5").results.remaining_dilation, largest);
}

// The block of a joint that wears by reversals slides some millimetres to and fro. The summary has them,
// wherever the run was stopped.
TEST_F(ContinuedRun, RestoresReversalsCloseToMinSlip) {
    CyclicBartonBandis law;
    law.barton = {2, 100e6, .3};
    law.peak_displacement = 5e-3;
    law.reversal_factor = .95;
    law.min_slip = 2e-3;
    const RoughnessTable wear = {{{0, 1}, {1, 1}, {2, .9}, {4, .7}}};
    law.cycles = {{wear, wear, wear, wear}};
    law.unsigned_ratios = true;
    for (JointMaterial& material : input.model.joint_materials) {
        material.law = law;
        material.shear_penalty = input.model.normal_penalty;
    }
    input.stages[1].base_motions = {
        {"base", TimeTable({0, .05, .15, .25, .35, .45}, {0, 6, -6, 6, -6, 6}), TimeTable({0}, {0})}};
    const auto list_of = [&](const std::string& name, int stop) {
        const Ended end = ended(name, stop);
        const std::string text =
            summary_text(input.model, input.stages, end.state, end.outcome, *end.results, {});
        const std::size_t from = text.find("\"reversals_close_to_min_slip\"");
        return text.substr(from, text.find("\"energy\"", from) - from);
    };
    const std::string whole = list_of("whole", 1'000'000);
    EXPECT_THAT(whole, HasSubstr("\"joint_material\": "));
    EXPECT_THAT(whole, HasSubstr("\"ended\": true"));
    const auto steps = static_cast<int>(lines_of(folder / "whole" / "steps.csv").size()) - 1;
    for (const int stop : {steps / 2, steps - 30, steps - 1})
        EXPECT_EQ(list_of("stopped" + std::to_string(stop), stop), whole) << stop;
}

// Data that a stepper keeps from step to step, such as its factor and work lists, must not affect the
// results: a new stepper that starts from a copy of the state gives the same bytes. Above some five hundred
// blocks the factor is in single precision and solutions are refined.
TEST(ContinuedSteps, OfAWallWithARefinedFactorAreTheSameBytes) {
    const Model model = scene::running_bond_wall(26, 24, 10).model;
    Stage stage;
    stage.control.force_tolerance = 1e-4;
    const auto stepped = [&](TimeStepper& stepper, State state, int steps) {
        for (int k = 0; k < steps; ++k) {
            StepAttempt attempt = stepper.advance(stage, state, 0.005);
            EXPECT_EQ(attempt.rejection, Rejection::none);
            state = std::move(attempt.state);
        }
        return state;
    };
    TimeStepper whole(model, 1);
    const State half = stepped(whole, initial_state(model), 3);
    const StateArchive end = archive(stepped(whole, half, 4));
    TimeStepper resumed(model, 1);
    const StateArchive again = archive(stepped(resumed, restore(archive(half)), 4));
    EXPECT_TRUE(again.reals == end.reals);
    EXPECT_EQ(again.integers, end.integers);
    EXPECT_EQ(again.bytes, end.bytes);
}

TEST_F(ContinuedRun, ACheckpointOfOtherContentIsRefused) {
    folder.write("checkpoint.h5", "not HDF5");
    EXPECT_THAT(io_test::error_of([&] { read_checkpoint(folder / "checkpoint.h5"); }),
                HasSubstr("cannot be resumed from"));
    EXPECT_THAT(io_test::error_of([&] { read_checkpoint(folder / "none.h5"); }),
                HasSubstr("there is no checkpoint to resume from"));
}

}  // namespace
}  // namespace rockslope::dda::resume_test
