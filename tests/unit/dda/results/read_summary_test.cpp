#include "dda/results/read_summary.hpp"

#include <gtest/gtest.h>

#include "common/base/input_error.hpp"
#include "unit/dda/input/small_models.hpp"

namespace rockslope::read_summary_test {
namespace {

std::optional<dda::WorstContact> read(const std::string& text) {
    const io_test::Folder folder;
    return dda::read_worst_contact(folder.write("summary.json", text));
}

TEST(ReadSummary, FindsTheWorstContact) {
    const auto worst = read(
        R"({"status": "not converged", "worst_contact": {"corner_block": 3, "edge_block": 1, "at": [1.5, -2],
            "joint_material": "bedding", "gap": 1e-3}})");
    ASSERT_TRUE(worst);
    EXPECT_EQ(worst->corner_block, 3);
    EXPECT_EQ(worst->edge_block, 1);
    EXPECT_EQ(worst->at, dda::Vec2(1.5, -2));
    EXPECT_EQ(worst->joint_material, "bedding");
}

TEST(ReadSummary, FindsNoneInACompletedRun) {
    EXPECT_FALSE(read(R"({"status": "completed"})"));
}

TEST(ReadSummary, FindsTheStatus) {
    const io_test::Folder folder;
    EXPECT_EQ(dda::read_status(folder.write("summary.json", R"({"status": "collapsed"})")), "collapsed");
    EXPECT_THROW(dda::read_status(folder.write("summary.json", R"({"status": 3})")), InputError);
}

TEST(ReadSummary, RefusesOtherFiles) {
    for (const char* text :
         {"", "{", "[]", "3", "{}", R"({"worst_contact": {}})", R"({"status": "x", "worst_contact": 3})",
          R"({"status": "x", "worst_contact": {"corner_block": 1, "edge_block": 2, "at": [1],
              "joint_material": "j"}})",
          R"({"status": "x", "worst_contact": {"corner_block": -1, "edge_block": 2, "at": [1, 2],
              "joint_material": "j"}})",
          R"({"status": "x", "worst_contact": {"corner_block": 1e30, "edge_block": 2, "at": [1, 2],
              "joint_material": "j"}})",
          R"({"status": "x", "worst_contact": {"corner_block": "1", "edge_block": 2, "at": [1, 2],
              "joint_material": "j"}})"})
        EXPECT_THROW(read(text), InputError) << text;
    EXPECT_THROW(dda::read_worst_contact("no/such/summary.json"), InputError);
}

}  // namespace
}  // namespace rockslope::read_summary_test
