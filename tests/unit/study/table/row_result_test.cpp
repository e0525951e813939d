#include "study/table/row_result.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace rockslope::row_result_test {
namespace {

using namespace study;
namespace fs = std::filesystem;

class RowResultTest : public ::testing::Test {
  protected:
    RowResultTest() {
        for (const char* name : {"row", "start"}) fs::create_directories(folder / name);
        measures[0].name = "crest";
        measures[0].point = "crest";
        measures[1] = measures[0];
        measures[1].is_peak = true;
        measures[2].region = "face";
        measures[2].is_largest = true;
        measures[3].kind = MeasureKind::first_slip;
        measures[4].kind = MeasureKind::factor_of_safety;
        measures[6].is_peak = true;
    }
    ~RowResultTest() override { fs::remove_all(folder); }
    void write(const std::string& file, const std::string& text) const {
        std::ofstream(folder / file) << text;
    }
    RowResult read() const {
        return read_row({folder / "row", folder / "start", folder / "cut.blocks"}, measures);
    }

    fs::path folder = fs::path(::testing::TempDir()) / ("row_result_" + std::to_string(::getpid()));
    std::vector<Measure> measures = std::vector<Measure>(7);
};

const char* const summary = R"({"status": "completed", "message": "", "wall_time": 2.5, "commit": "0a",
"points": [{"name": "crest", "permanent_displacement": [3, -4], "peak_relative_displacement": 6}],
"farthest_block": {"block": 3, "displacement": 8, "peak_displacement": 9},
"regions": [{"name": "face", "largest_displacement": 7}],
"first_slip": {"blocks": 3, "first_time_of_shaking": 0.25},
"factor_of_safety": {"stands": 1.0, "fails": 1.21},
"motions": [{"peak_acceleration": 1, "peak_velocity": 9}, {"peak_acceleration": 2, "peak_velocity": 0.3,
"spectral_acceleration": [{"period": 0.5, "acceleration": 4.5}]}]})";

TEST_F(RowResultTest, ReadsTheMeasuresOfARowThatIsDone) {
    write("row/summary.json", summary);
    write("row/blocks.csv", "block\n");
    const RowResult result = read();
    EXPECT_EQ(result.state, RowState::completed);
    EXPECT_EQ(result.measures[0], 5);
    EXPECT_EQ(result.measures[1], 6);
    EXPECT_EQ(result.measures[2], 7);
    EXPECT_EQ(result.measures[3], 0.25);
    EXPECT_NEAR(*result.measures[4], 1.1, 1e-12);
    EXPECT_EQ(result.measures[5], 8) << "the farthest block";
    EXPECT_EQ(result.measures[6], 9);
    EXPECT_EQ(result.intensities[0], 2) << "of the strongest motion";
    EXPECT_EQ(result.intensities[1], 0.3);
    EXPECT_EQ(intensity_headings()[10], "Sa(0.5) (m/s2)");
    EXPECT_EQ(result.intensities[10], 4.5);
    EXPECT_FALSE(result.intensities[11]);
    EXPECT_EQ(result.wall_time, 2.5);
}

TEST(Intensities, GrowWithTheMotion) {
    std::vector<std::optional<double>> values(intensity_headings().size(), 10);
    values[1].reset();
    scale_intensities(3, values);
    const auto of = [&](const char* name) {
        const auto headings = intensity_headings();
        return values[static_cast<std::size_t>(std::find(headings.begin(), headings.end(), name) -
                                               headings.begin())];
    };
    EXPECT_EQ(of("PGA (m/s2)"), 30);
    EXPECT_FALSE(of("PGV (m/s)"));
    EXPECT_EQ(of("PGD (m)"), 30);
    EXPECT_EQ(of("Arias (m/s)"), 90);
    EXPECT_EQ(of("D5-95 (s)"), 10);
    EXPECT_EQ(of("CAV (m/s)"), 30);
    EXPECT_EQ(of("Tm (s)"), 10);
    EXPECT_EQ(of("Sa(0.1) (m/s2)"), 30);
    EXPECT_EQ(of("Sa(3) (m/s2)"), 30);
}

TEST_F(RowResultTest, KnowsWhereARowIs) {
    EXPECT_EQ(read().state, RowState::waiting);
    write("cut.log", "slope.toml: no rock\n");
    EXPECT_EQ(read().cause, "cut");
    EXPECT_EQ(read().message, "slope.toml: no rock");
    write("cut.blocks", "");
    EXPECT_EQ(read().state, RowState::waiting);
    write("start/failed.json", R"({"status": "not settled", "message": "block 3"})");
    EXPECT_EQ(read().cause, "start not settled");
    write("row/checkpoint.h5", "");
    EXPECT_EQ(read().state, RowState::stopped) << "interrupted";
    std::string host;
    std::ifstream("/proc/sys/kernel/hostname") >> host;
    write("row/running", host + " " + std::to_string(::getpid()));
    EXPECT_EQ(read().state, RowState::running);
    const pid_t ended = ::fork();
    if (ended == 0) ::_exit(0);
    siginfo_t seen{};
    ::waitid(P_PID, static_cast<id_t>(ended), &seen, WEXITED | WNOWAIT);
    write("row/running", host + " " + std::to_string(ended));
    EXPECT_EQ(read().state, RowState::stopped) << "its process has ended, and nobody has waited for it";
    ::waitpid(ended, nullptr, 0);
    write("row/running", host + " 999999999");
    EXPECT_EQ(read().state, RowState::stopped) << "its process is gone";
    write("row/running", "");
    fs::remove(folder / "row" / "checkpoint.h5");
    write("row/log", "run.toml:3: unknown key\n");
    EXPECT_EQ(read().state, RowState::failed) << "ended, and left neither a summary nor a checkpoint";
    EXPECT_EQ(read().message, "run.toml:3: unknown key");
    write("row/log", "results/a/run.vtkhdf: cannot be written: No space left on device\n");
    EXPECT_EQ(read().cause, "not written");
    write("row/log", "");
    EXPECT_EQ(read().cause, "not written") << "the disk had no room for the first line";
    EXPECT_EQ(read().message, "log: cannot be written: no space left");
    write("row/failed.json", R"({"status": "not converged", "message": "block 4"})");
    EXPECT_EQ(read().state, RowState::failed);
    EXPECT_EQ(read().cause, "not converged");
    write("row/failed.json", R"({"status": "stopped", "message": ""})");
    EXPECT_EQ(read().state, RowState::stopped);
    write("row/summary.json",
          R"({"status": "collapsed", "message": "block 5", "collapse": {"time": 3, "limit": 2}})");
    EXPECT_EQ(read().state, RowState::collapsed);
    EXPECT_EQ(read().collapse_limit, 2);
}

}  // namespace
}  // namespace rockslope::row_result_test
