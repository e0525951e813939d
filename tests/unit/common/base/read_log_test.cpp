#include "common/base/read_log.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "common/base/input_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/sha256.hpp"

namespace rockslope::read_log_test {
namespace {

namespace fs = std::filesystem;

class ReadLogTest : public ::testing::Test {
  protected:
    void TearDown() override { fs::remove(path); }
    void write(const std::string& text) const { std::ofstream(path) << text; }

    fs::path path = fs::path(::testing::TempDir()) / ("read_log_" + std::to_string(::getpid()));
};

TEST_F(ReadLogTest, NotesTheBytesThatWereRead) {
    write("first");
    const ReadLog log;
    read_text_file(path);
    write("second");
    ASSERT_EQ(log.files().size(), 1u);
    EXPECT_EQ(log.files()[0].path, path);
    EXPECT_EQ(log.digest_of(path), sha256("first")) << "of what was read, not of what is there now";
    EXPECT_EQ(log.digest_of("other"), "");
}

TEST_F(ReadLogTest, RefusesAFileThatChangesBetweenTwoReadings) {
    write("first");
    const ReadLog log;
    read_text_file(path);
    EXPECT_NO_THROW(read_text_file(path));
    EXPECT_EQ(log.files().size(), 1u);
    write("second");
    EXPECT_THROW(read_text_file(path), InputError);
}

TEST_F(ReadLogTest, ALogWithinAnotherAddsToBoth) {
    write("text");
    const ReadLog outer;
    {
        const ReadLog inner;
        read_text_file(path);
        EXPECT_EQ(inner.files().size(), 1u);
    }
    EXPECT_EQ(outer.files().size(), 1u);
}

TEST_F(ReadLogTest, WithoutALogNothingIsNoted) {
    write("text");
    EXPECT_EQ(read_text_file(path), "text");
    const ReadLog log;
    EXPECT_TRUE(log.files().empty());
}

}  // namespace
}  // namespace rockslope::read_log_test
