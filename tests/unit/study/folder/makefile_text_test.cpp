#include "study/folder/makefile_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/folder/row_settings.hpp"
#include "study/folder/study_folder.hpp"

namespace rockslope::makefile_text_test {
namespace {

using namespace study;
using ::testing::HasSubstr;
using ::testing::Not;

/// A study of two rows that begin with one start, and a third row of the address of the second.
PlannedStudy small_study() {
    PlannedStudy study;
    study.plan.file = "/home/a b/plan.toml";
    study.plan.slope = "/home/a b/slope.toml";
    study.plan.run = "/home/a b/run.toml";
    study.plan.factors.resize(1);
    study.plan.factors[0].name = "scale";
    study.branch_stages = 1;
    study.last_start_stage = "settle";
    study.cuts = {{"c0", {}}};
    study.starts = {{"s0", 0, {}, 3}};
    for (const char* address : {"r0", "r1", "r1"}) {
        PlannedRow row;
        row.address = address;
        row.row.values = {"\"1, 5\""};
        Setting value, file;
        value.target.key = "stage[1].x";
        value.value = "[1, \"$5\"]";
        file.target.key = "stage[1].file";
        file.file = "/home/a b/it's.at2";
        row.settings.push_back(value);
        row.settings.push_back(file);
        study.rows.push_back(row);
    }
    study.inputs = {"/home/a b/plan.toml"};
    return study;
}

TEST(MakefileText, ComputesEachAddressOnce) {
    const std::string text = makefile_text(small_study(), "/home/a b/study", {"/opt/bin"});
    for (const char* part : {"\ncuts/c0.blocks:\n",
                             "\nstarts/s0/stage-1.saved.h5: cuts/c0.blocks\n\t$(call start,--until settle",
                             "\nruns/000003/summary.json: results/r1/summary.json ;\n",
                             "Makefile: \\\n    ../plan.toml\n", "SLOPE = ../slope.toml\n"})
        EXPECT_THAT(text, HasSubstr(part));
    EXPECT_EQ(text.find("\nresults/r1/summary.json:"), text.rfind("\nresults/r1/summary.json:"))
        << "one rule";
    EXPECT_THAT(text, HasSubstr("--set 'stage[1].x=[1$(comma) \"$$5\"]'")) << "commas and dollars of $(call)";
    EXPECT_THAT(text, HasSubstr("--set 'stage[1].file=\"../it'\\''s.at2\"'"));
}

TEST(MakefileText, RowsRunFromTheBeginningWhereNothingIsShared) {
    PlannedStudy study = small_study();
    study.branch_stages = 0;
    study.starts.clear();
    const std::string text = makefile_text(study, "/home/a b/study", {"/opt/bin"});
    EXPECT_THAT(text, HasSubstr("$(call row,"));
    EXPECT_THAT(text, Not(HasSubstr("--from starts")));
}

TEST(StudyFolder, TheTableOfRunsHasLabelsAndAddresses) {
    const TextTable table = runs_table(small_study());
    EXPECT_EQ(csv_text(table),
              "row,scale,replicate,design block,design place,cut,start,address\n"
              "1,\"1, 5\",0,,,c0,s0,r0\n2,\"1, 5\",0,,,c0,s0,r1\n3,\"1, 5\",0,,,c0,s0,r1\n");
}

TEST(PlannedStudy, KnowsTheStageOfAKey) {
    EXPECT_EQ(stage_of_key("stage[12].step"), 12);
    EXPECT_EQ(stage_of_key("stage[x].step"), -1);
    EXPECT_EQ(stage_of_key("stages[1].step"), -1);
    EXPECT_EQ(stage_of_key("joint_material.stage"), -1);
}

}  // namespace
}  // namespace rockslope::makefile_text_test
