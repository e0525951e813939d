#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "common/base/atomic_file.hpp"
#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"
#include "dda/hdf/vtkhdf_file.hpp"

namespace rockslope::damaged_file_test {
namespace {

using namespace dda;
namespace fs = std::filesystem;

class DamagedFile : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("damaged_file_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        path = folder_ / "frames.vtkhdf";
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path path;

  private:
    fs::path folder_;
};

/// Two frames of a triangle.
void write_frames(const fs::path& path) {
    GridCells cells;
    cells.offsets = {0};
    cells.add({0, 1, 2}, 7);
    GridLayout layout;
    layout.columns = {{"displacement", 3}, {"stress", 1}};
    VtkHdfFile file(path, layout, cells, 3);
    for (const double time : {0.0, 0.5})
        file.append({.time = time,
                     .stage = "settle",
                     .points = {0, 0, 0, 1, 0, 0, 0, 1, 0},
                     .columns = {{1, 2, 3}, {4}}});
}

enum Outcome { read_whole, refused, other_error };

/// Reads all of a file in a process of its own, since the library cannot be used once it has failed.
/// @return the outcome, or minus the signal that ended the process.
int outcome_of_reading(const fs::path& path) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(20);
        try {
            const VtkHdfReader reader(path);
            for (std::int64_t k = 0; k < reader.frame_count(); ++k) reader.frame(k, reader.column_names());
            ::_exit(read_whole);
        } catch (const OutputError&) {
            ::_exit(refused);
        } catch (...) {
            ::_exit(other_error);
        }
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

// HDF5 1.10 divides by zero where a chunk has no rows: dda-plot died of SIGFPE.
TEST_F(DamagedFile, IsReadOrRefusedWhateverByteIsZero) {
    write_frames(path);
    ASSERT_EQ(outcome_of_reading(path), read_whole);
    const std::string whole = read_text_file(path);
    int refusals = 0;
    const std::size_t end = std::min<std::size_t>(whole.size(), 14000);  // the headers of the datasets
    for (std::size_t at = 0; at < end; at += 2) {
        if (whole[at] == 0) continue;
        std::string damaged = whole;
        damaged[at] = 0;
        std::ofstream(path, std::ios::binary) << damaged;
        const int outcome = outcome_of_reading(path);
        ASSERT_TRUE(outcome == read_whole || outcome == refused) << "outcome " << outcome << ", byte " << at;
        refusals += outcome == refused ? 1 : 0;
    }
    EXPECT_GT(refusals, 100);
}

TEST_F(DamagedFile, DeclaresNoMoreThanItHolds) {
    {
        HdfFile file = HdfFile::create(path);
        file.add_dataset("/many", HdfType::f8, 1, std::size_t{1} << 20, true);
        file.append("/many", std::vector<double>(std::size_t{1} << 20));
        file.add_dataset("/texts", HdfType::i8, 1, 4, false);
        file.append("/texts", std::vector<std::int64_t>{1, 2, 3});
        file.set_attribute("/", "numbers", std::vector<std::int64_t>(1000, 7));
    }
    const HdfFile file = HdfFile::open_to_read(path);
    EXPECT_EQ(file.read_all<double>("/many").size(), std::size_t{1} << 20) << "deflated zeros are believed";
    EXPECT_THROW(file.integer_attribute("/", "numbers"), OutputError) << "a thousand numbers are not one";
    EXPECT_THROW(file.string_attribute("/", "numbers"), OutputError);
    EXPECT_THROW(file.read_texts("/texts"), OutputError);
    EXPECT_THROW(file.read<double>("/many", 5, std::numeric_limits<std::size_t>::max()), OutputError);
}

}  // namespace
}  // namespace rockslope::damaged_file_test
