#include "study/table/sqlite_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "common/base/atomic_file.hpp"
#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"

namespace rockslope::study::sqlite_file_test {
namespace {

namespace fs = std::filesystem;

class SqliteFile : public ::testing::Test {
  protected:
    void SetUp() override {
        folder = fs::path(::testing::TempDir()) / ("sqlite_file_" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    std::size_t files_in_folder() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }
    fs::path folder;
    const TextTable table{{"row", "crest (m)"}, {{"1", "0.25"}, {"2", ""}}};
};

// The name was results.sqlite.tmp: whoever could write into the folder chose what was removed, or written to.
TEST_F(SqliteFile, FollowsNoLinkAndRemovesNoFileOfTheUser) {
    write_file_atomically(folder / "victim", "precious");
    fs::create_symlink("victim", folder / "results.sqlite.tmp");
    for (int time = 0; time < 2; ++time) {
        write_sqlite(folder / "results.sqlite", {{"results", table}});
        EXPECT_EQ(read_text_file(folder / "victim"), "precious");
        EXPECT_TRUE(fs::is_symlink(folder / "results.sqlite.tmp"));
        EXPECT_EQ(read_text_file(folder / "results.sqlite").substr(0, 15), "SQLite format 3");
        EXPECT_EQ(files_in_folder(), 3u) << "neither a temporary file nor a journal is left";
    }
}

TEST_F(SqliteFile, AFailureKeepsTheOldFile) {
    write_file_atomically(folder / "results.sqlite", "the old one");
    const std::vector<NamedTable> twice = {{"results", table}, {"results", table}};
    EXPECT_THROW(write_sqlite(folder / "results.sqlite", twice), OutputError);
    EXPECT_EQ(read_text_file(folder / "results.sqlite"), "the old one");
    EXPECT_EQ(files_in_folder(), 1u);
    EXPECT_THROW(write_sqlite(folder / "missing" / "results.sqlite", {{"results", table}}), OutputError);
}

}  // namespace
}  // namespace rockslope::study::sqlite_file_test
