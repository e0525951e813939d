#include "common/base/atomic_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"
#include "support/error_of.hpp"

namespace rockslope::atomic_file_test {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public ::testing::Test {
  protected:
    void SetUp() override {
        folder = fs::path(::testing::TempDir()) / ("atomic_file_" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    std::size_t files_in_folder() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }
    fs::path folder;
};

TEST_F(AtomicFile, WritesTheBytesAndLeavesNoTemporaryFile) {
    const std::string bytes("a\0b\r\n", 5);
    write_file_atomically(folder / "f", bytes);
    EXPECT_EQ(read_text_file(folder / "f"), bytes);
    write_file_atomically(folder / "f", "");
    EXPECT_EQ(read_text_file(folder / "f"), "");
    EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(AtomicFile, FailureKeepsTheOldFile) {
    fs::create_directory(folder / "d");
    fs::create_directory(folder / "d" / "inner");
    EXPECT_THROW(write_file_atomically(folder / "d", "x"), OutputError);
    EXPECT_EQ(files_in_folder(), 1u) << "the temporary file must be removed";
    EXPECT_THROW(write_file_atomically(folder / "missing" / "f", "x"), OutputError);
}

// The name was that of the process, which an attacker, or a run of the same number on another machine, has.
TEST_F(AtomicFile, TheTemporaryNameIsRandomAndNeverThatOfALink) {
    fs::path first;
    {
        const PendingFile a(folder / "f"), b(folder / "f");
        EXPECT_NE(a.temporary(), b.temporary());
        EXPECT_EQ(a.temporary().parent_path(), folder);
        EXPECT_TRUE(fs::is_regular_file(a.temporary()));
        first = a.temporary();
    }
    EXPECT_EQ(files_in_folder(), 0u) << "files that are not put in place are removed";
    write_file_atomically(folder / "f.tmp0123456789ab", "left by a kill");
    write_file_atomically(folder / "f.tmp", "a user's");
    write_file_atomically(folder / "f.tmp0123456789xy", "a user's");
    remove_abandoned_files(folder);
    EXPECT_FALSE(fs::exists(folder / "f.tmp0123456789ab"));
    EXPECT_EQ(files_in_folder(), 2u);
}

TEST_F(AtomicFile, ReportsAFullDevice) {
    EXPECT_EQ(error_of<OutputError>([] { write_file_atomically("/dev/full", "x"); }),
              "/dev/full: cannot be written: No space left on device");
}

TEST_F(AtomicFile, UnreadablePathsAreInputErrors) {
    EXPECT_THROW(read_text_file(folder), InputError);
    EXPECT_EQ(
        error_of([&] { read_text_file(folder / "none"); }),
        (folder / "none").string() + ": cannot be read: No such file or directory; expected a readable file");
}

}  // namespace
}  // namespace rockslope::atomic_file_test
