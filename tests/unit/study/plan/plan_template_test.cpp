#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "study/plan/plan.hpp"
#include "support/error_of.hpp"

namespace rockslope::plan_template_test {
namespace {

namespace fs = std::filesystem;

TEST(PlanTemplate, IsAPlan) {
    const fs::path folder = fs::path(::testing::TempDir()) / ("template_" + std::to_string(::getpid()));
    fs::create_directories(folder / "records");
    std::ofstream(folder / "records/a.at2") << "record";
    std::ofstream(folder / "plan.toml") << study::plan_template();
    EXPECT_EQ(error_of([&] { EXPECT_EQ(study::read_plan(folder / "plan.toml").factors.size(), 3u); }),
              "no error");
    fs::remove_all(folder);
}

}  // namespace
}  // namespace rockslope::plan_template_test
