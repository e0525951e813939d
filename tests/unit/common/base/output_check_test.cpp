#include "common/base/output_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "support/error_of.hpp"

namespace rockslope::output_check_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr ::uid_t nobody = 65534;

/// Ends the process after it has written the error of an action for a user without the rights of root.
template <class Action>
[[noreturn]] void print_error_without_root(const Action& action) {
    if (::getuid() == 0 && ::setuid(nobody) != 0) std::_Exit(2);
    std::fputs(error_of(action).c_str(), stderr);
    std::_Exit(0);
}

class OutputCheck : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(folder / "sub");
        std::ofstream(folder / "model.toml") << "x";
        std::ofstream(folder / "record.csv") << "x";
        fs::create_symlink(folder / "record.csv", folder / "link.csv");
    }
    void TearDown() override { fs::remove_all(folder); }

    std::string error_for(const fs::path& file, const fs::path& created_later = {}) const {
        return error_of([&] {
            check_output(folder / file, {folder / "model.toml", folder / "record.csv"}, created_later);
        });
    }

    const fs::path folder = fs::path(testing::TempDir()) / ("output_check_" + std::to_string(::getpid()));
};

TEST_F(OutputCheck, AcceptsWritablePaths) {
    EXPECT_EQ(error_for("new.blocks"), "no error");
    EXPECT_EQ(error_for("sub/new.blocks"), "no error");
    EXPECT_EQ(error_of([] { check_output("/dev/null", {}); }), "no error");
    EXPECT_EQ(error_for("later/run.d", folder / "later"), "no error") << "the program makes that folder";
    EXPECT_EQ(error_of([&] { check_output_folder(folder / "later" / "still"); }), "no error");
}

TEST_F(OutputCheck, RejectsUnwritablePaths) {
    EXPECT_THAT(error_for("sub"), HasSubstr("this is a folder"));
    EXPECT_THAT(error_for("later/run.d"), HasSubstr("no such folder"));
    EXPECT_THAT(error_for("model.toml/run.d"), HasSubstr("no such folder"));
    EXPECT_THAT(error_for(std::string(250, 'x')), HasSubstr("cannot be written: File name too long"));
    EXPECT_THAT(error_of([&] { check_output_folder(folder / "model.toml"); }), HasSubstr("Not a directory"));
    EXPECT_THAT(error_of([&] { check_output_folder(folder / "model.toml" / "out"); }),
                HasSubstr("expected a folder for the results"));
}

// The rights of a folder bind everybody but root, so root tries as another user.
TEST_F(OutputCheck, RejectsAFolderWithoutTheRightToWrite) {
    const fs::perms readable = fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read |
                               fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;
    fs::permissions(folder, readable | fs::perms::owner_write);
    fs::permissions(folder / "sub", readable);
    const testing::ExitedWithCode rejected(0);
    EXPECT_EXIT(print_error_without_root([&] { check_output(folder / "sub" / "new.blocks", {}); }), rejected,
                "sub/new.blocks.*Permission denied");
    EXPECT_EXIT(print_error_without_root([&] { check_output_folder(folder / "sub" / "out"); }), rejected,
                "sub/out.*Permission denied");
}

TEST_F(OutputCheck, RejectsAnInputUnderAnySpelling) {
    EXPECT_THAT(error_for("model.toml"), HasSubstr("overwrite the model file"));
    EXPECT_THAT(error_for("sub/../model.toml"), HasSubstr("overwrite the model file"));
    EXPECT_THAT(error_for("record.csv"), HasSubstr("overwrite the input file"));
    EXPECT_THAT(error_for("link.csv"), HasSubstr("overwrite the input file"));
}

TEST_F(OutputCheck, RejectsTwoResultsInTheSameFile) {
    const auto error_for_both = [&](const fs::path& a, const fs::path& b) {
        return error_of([&] { check_distinct({a, {}, b, {}}); });
    };
    EXPECT_EQ(error_for_both("a.csv", "b.csv"), "no error");
    EXPECT_THAT(error_for_both("a.csv", "./a.csv"), HasSubstr("two results are the same file"));
    EXPECT_THAT(error_for_both(folder / "sub" / ".." / "a", folder / "a"), HasSubstr("different names"));
}

}  // namespace
}  // namespace rockslope::output_check_test
