#include "dda/checkpoint/start_of_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dda/analysis/run.hpp"
#include "unit/dda/results/run_in_a_folder.hpp"

namespace rockslope::dda::start_of_run_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const char* const fingerprint = R"(blocks = "5f"

[joint_material.bedding]
cohesion = 0.0

[[measured_region]]
name = "face"

[[stage]]
name = "settle"

[stage.stop]
displacement = 1.0

[[stage]]
name = "shake"

[stage.base_motion.x]
file = "8c"

[output]
frames = 10
relative_to = "base"
)";

TEST(StartOfRun, HasWhatTheStateDependsOn) {
    const std::string first = start_of_run(fingerprint, 1);
    for (const char* kept : {"blocks = \"5f\"", "[joint_material.bedding]\ncohesion = 0.0\n",
                             "name = \"settle\"", "[stage.stop]", "relative_to"})
        EXPECT_THAT(first, HasSubstr(kept));
    for (const char* left : {"shake", "base_motion", "8c", "frames", "face", "measured_region"})
        EXPECT_THAT(first, Not(HasSubstr(left)));
    EXPECT_THAT(start_of_run(fingerprint, 2), HasSubstr("[stage.base_motion.x]\nfile = \"8c\"\n"));
}

TEST(StartOfRun, NamesTheFirstDifference) {
    const std::string saved = start_of_run(fingerprint, 1);
    EXPECT_FALSE(first_difference(saved, saved));
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string text = saved;
        text.replace(text.find(from), from.size(), to);
        return first_difference(text, saved).value_or("none");
    };
    EXPECT_EQ(changed("cohesion = 0.0", "cohesion = 5.0"),
              "[joint_material.bedding] has 'cohesion = 5.0', the saved run has 'cohesion = 0.0'");
    EXPECT_EQ(changed("5f", "6f"), "the block file is not that of the saved run");
    EXPECT_EQ(changed("cohesion = 0.0\n", ""),
              "[joint_material.bedding] has one line less, the saved run has 'cohesion = 0.0'");
    EXPECT_EQ(changed("[stage.stop]\ndisplacement = 1.0\n", ""),
              "[output] is not in this place of the saved run");
    EXPECT_EQ(first_difference("", saved).value_or("none"),
              "the model has one line less, the saved run has "
              "'blocks = \"5f\"'");
}

using SavedStage = RunInAFolder;

TEST_F(SavedStage, IsRefusedWhereItIsNone) {
    input.output.checkpoint_interval = 1e-9;
    simulate("a");
    const auto error_of_saved = [&](const char* file) {
        return error_of([&] { read_saved_state(folder / "a" / file, input.fingerprint, 2); });
    };
    EXPECT_THAT(error_of_saved("checkpoint.h5"), HasSubstr("is a checkpoint from within a stage"));
    EXPECT_THAT(
        error_of_saved("stage-1.saved.h5"),
        AllOf(HasSubstr("there is no such file"), HasSubstr("the end of a stage that another run saved")));
    EXPECT_THAT(error_of_saved("run.vtkhdf"), HasSubstr("cannot be resumed from"));
}

}  // namespace
}  // namespace rockslope::dda::start_of_run_test
