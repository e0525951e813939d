#include "study/csv/csv_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "support/error_of.hpp"

namespace rockslope::csv_text_test {
namespace {

using namespace study;
using ::testing::HasSubstr;

TextTable read(const std::string& text) {
    const auto file = std::filesystem::path(::testing::TempDir()) / ("csv_" + std::to_string(::getpid()));
    std::ofstream(file, std::ios::binary) << text;
    struct Remove {
        const std::filesystem::path& path;
        ~Remove() { std::filesystem::remove(path); }
    } const remove{file};
    return read_csv(file);
}

TEST(CsvText, ReadsBackWhatItWrites) {
    const TextTable table{{"a", "crest (m)"}, {{"1,5", "a \"quoted\" one"}, {"", "two\nlines"}}};
    const TextTable back = read(csv_text(table));
    EXPECT_EQ(back.heading, table.heading);
    EXPECT_EQ(back.rows, table.rows);
    EXPECT_EQ(read("a,b\r\n1,2\r\n").rows, (std::vector<std::vector<std::string>>{{"1", "2"}}));
    EXPECT_EQ(read("a\n1").rows.size(), 1u) << "no line end at the end";
}

TEST(CsvText, FindsColumnsWithAndWithoutTheirUnit) {
    const TextTable table{{"PGA", "crest (m)", "PGA (g)"}, {}};
    EXPECT_EQ(table.find("crest"), 1u);
    EXPECT_EQ(table.find("crest (m)"), 1u);
    EXPECT_EQ(table.find("PGA"), 0u);
    EXPECT_FALSE(table.find("cres"));
}

TEST(CsvText, RefusesTablesThatAreNone) {
    EXPECT_THAT(error_of([] { read(""); }), HasSubstr("is empty"));
    EXPECT_THAT(error_of([] { read("a,b\n1\n"); }), HasSubstr(":2: has 1 fields; expected 2"));
    EXPECT_THAT(error_of([] { read("a\n\"1\n"); }), HasSubstr("not closed"));
    EXPECT_THAT(error_of([] { read("a\n\"1\"2\n"); }), HasSubstr("text after a quoted field"));
}

}  // namespace
}  // namespace rockslope::csv_text_test
