// The report of the verification tests: the recorded rows agree with the assertions, and the check finds
// differences.

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "report/page.hpp"
#include "report/pictures.hpp"
#include "support/catalogue.hpp"
#include "support/record.hpp"

namespace rockslope::report_test {
namespace {

namespace fs = std::filesystem;
using namespace verification;

/// A report folder of the test, set in the environment variable with which cases record rows.
class Report : public testing::Test {
  protected:
    void SetUp() override {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder_ = fs::path(testing::TempDir()) / ("report_" + name);
        fs::remove_all(folder_);
        setenv("DDA_VERIFICATION_REPORT", folder_.c_str(), 1);
    }
    void TearDown() override {
        unsetenv("DDA_VERIFICATION_REPORT");
        fs::remove_all(folder_);
    }
    std::vector<Row> rows() const {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        return read_rows((folder_ / ("Report." + name + ".tsv")).string());
    }
    fs::path folder_;
};

TEST_F(Report, RecordsTheToleranceThatItAsserts) {
    Case("V08", "a", "because").contact_frequency_step(.1).expect("s", "m", 1.0009, 1, relative(1e-3));
    EXPECT_NONFATAL_FAILURE(Case("V08", "b", "because").expect("s", "m", 1.0011, 1, relative(1e-3)),
                            "error 0.0011");
    const std::vector<Row> made = rows();
    ASSERT_EQ(made.size(), 2u);
    EXPECT_EQ(made[0].verdict, Verdict::passes);
    EXPECT_EQ(made[0].tolerance, "0.001");
    EXPECT_EQ(made[0].error, "0.0009");
    EXPECT_EQ(made[0].contact_frequency_step, "0.1");
    EXPECT_EQ(made[0].reason, "because");
    EXPECT_EQ(made[1].verdict, Verdict::fails);
    EXPECT_EQ(made[1].contact_frequency_step, "");
}

TEST_F(Report, EvaluatesEachKind) {
    const Case c("V01", "a", "r");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    c.expect("absolute", "m", -1e-3, 0, absolute(1e-3));
    EXPECT_NONFATAL_FAILURE(c.expect("absolute too far", "m", 1.1e-3, 0, absolute(1e-3)), "V01");
    EXPECT_NONFATAL_FAILURE(c.expect("not a number", "m", nan, 0, absolute(1e-3)), "V01");
    c.expect_below("below", "m", -.9, 1);
    EXPECT_NONFATAL_FAILURE(c.expect_below("not below", "m", -1.1, 1), "V01");
    EXPECT_NONFATAL_FAILURE(c.expect_below("below, not a number", "m", nan, 1), "V01");
    c.expect_above("above", "m", 1.1, 1);
    EXPECT_NONFATAL_FAILURE(c.expect_above("not above", "m", -2, 1), "V01");
    c.expect_outcome("mode", "slides", "slides");
    EXPECT_NONFATAL_FAILURE(c.expect_outcome("other mode", "slides", "topples"), "topples");
    c.expect_miss("miss", "m", 2, 1, {.tolerance = relative(.1), .reason = "why"});
    EXPECT_NONFATAL_FAILURE(c.expect_miss("healed", "m", 1, 1, {.tolerance = relative(.1), .reason = "why"}),
                            "no longer a miss");
    c.inform("inform", "m", 7, 1);
    EXPECT_EQ(rows().size(), 13u);
}

TEST_F(Report, RefusesUnknownCasesAndInvalidTexts) {
    EXPECT_THROW(Case("V99", "a", "r"), std::out_of_range);
    EXPECT_THROW(Case("V01", "a | b", "r"), std::invalid_argument);
    EXPECT_THROW(Case("V01", "a", "r").expect("q", "m", 0, 0, relative(.1)), std::invalid_argument);
}

TEST_F(Report, RefusesMalformedRows) {
    fs::create_directories(folder_);
    const std::string path = (folder_ / "bad.tsv").string();
    EXPECT_THROW(read_rows(path), std::runtime_error);
    std::ofstream(path) << "something else\n";
    EXPECT_THROW(read_rows(path), std::runtime_error);
    {
        std::ofstream out(path);
        write_header(out);
        out << "V01\ttoo few\n";
    }
    EXPECT_THROW(read_rows(path), std::runtime_error);
}

Row passing(const std::string& id, const std::string& quantity) {
    Row row;
    row.id = id;
    row.set_up = "a";
    row.quantity = quantity;
    row.expected = "1";
    row.ours = "1.001";
    row.error = "0.001";
    row.tolerance = "0.01";
    row.kind = ToleranceKind::relative;
    row.verdict = Verdict::passes;
    return row;
}

TEST(Differences, AreOfRowsVerdictsAndTolerancesButNotDigits) {
    const std::vector<Row> committed = {passing("V01", "x"), passing("V02", "y")};
    std::vector<Row> fresh = committed;
    fresh[0].ours = "1.002";
    fresh[0].error = "0.002";
    EXPECT_TRUE(differences(committed, fresh).empty());
    fresh[0].tolerance = "0.1";
    fresh[1].verdict = Verdict::misses;
    fresh.push_back(passing("V03", "z"));
    EXPECT_EQ(differences(committed, fresh).size(), 3u);
    fresh = {committed[0]};
    ASSERT_EQ(differences(committed, fresh).size(), 1u);
    EXPECT_NE(differences(committed, fresh)[0].find("V02"), std::string::npos);
}

TEST(Page, ListsEveryCaseAndMarksMissingOnes) {
    EXPECT_THROW(in_order({passing("V01", "x"), passing("V01", "x")}), std::runtime_error);
    const std::string text =
        page(in_order({passing("V08", "s"), passing("V02", "p")}), {{"V08", "p.svg", "curve"}});
    for (const CatalogueCase& entry : catalogue)
        EXPECT_NE(text.find(entry.title), std::string::npos) << entry.id;
    EXPECT_LT(text.find("</a>V02"), text.find("</a>V08"));
    EXPECT_NE(text.find("| V01 | Free fall | 0 |  |  | not covered yet |"), std::string::npos);
    EXPECT_NE(text.find("| a | s | 1 | 1.001 | 0.1 % | 1 % |  | within |"), std::string::npos);
    EXPECT_NE(text.find("![curve](p.svg)"), std::string::npos);
    EXPECT_EQ(text.find("misses"), std::string::npos);
    Row missed = passing("V18", "slip");
    missed.verdict = Verdict::misses;
    missed.reason = "why";
    const std::string with_miss = page({missed}, {});
    EXPECT_NE(with_miss.find("- [V18](#V18), a: slip is 1.001, expected 1."), std::string::npos);
    EXPECT_NE(with_miss.find("Misses: why"), std::string::npos);
}

TEST(Page, ShowsEnergyInASeparateTable) {
    Row residual = passing("V10", energy_residual);
    residual.ours = "2e-05";
    residual.kind = ToleranceKind::below;
    Row friction = passing("V10", friction_work);
    friction.ours = "0";
    Row loss = passing("V10", integration_loss);
    loss.ours = "0.25";
    loss.verdict = Verdict::informs;
    const std::string text = page({passing("V10", "s"), residual, friction, loss}, {});
    EXPECT_NE(text.find("| [V10](#V10) | a | 2e-05 | 0 | 0.25 | within |"), std::string::npos) << text;
    EXPECT_EQ(text.find(std::string("| a | ") + energy_residual), std::string::npos);
    friction.verdict = Verdict::fails;
    EXPECT_NE(page({residual, friction, loss}, {}).find("| 0.25 | **outside** |"), std::string::npos);
}

TEST(Balances, AreRequiredOfDynamicCases) {
    const Row statics = passing("V02", "p");
    const Row moves = passing("V10", "s");
    Row balance = passing("V10", energy_residual);
    EXPECT_TRUE(missing_balances({statics}).empty());
    EXPECT_TRUE(missing_balances({statics, moves, balance}).empty());
    EXPECT_EQ(missing_balances({statics, moves}).size(), 1u);
}

TEST_F(Report, PicturesReadBackAsRecorded) {
    record_picture("V14", "slip", "Slip", "time, s", "slip, m",
                   {{"closed form", {0, 1}, {0, 2}}, {"engine", {0, 1, 2}, {0, 1, 3}}});
    const std::vector<Picture> pictures = read_pictures(folder_.string());
    ASSERT_EQ(pictures.size(), 1u);
    EXPECT_EQ(pictures[0].id, "V14");
    EXPECT_EQ(pictures[0].stem, "V14-slip");
    ASSERT_EQ(pictures[0].curves.size(), 2u);
    EXPECT_EQ(pictures[0].curves[0].name, "closed form");
    EXPECT_EQ(pictures[0].curves[1].y, (std::vector<double>{0, 1, 3}));
    const std::string drawing = draw(pictures[0]);
    EXPECT_EQ(drawing.rfind("<svg", 0), 0u);
    EXPECT_NE(drawing.find("closed form"), std::string::npos);
}

}  // namespace
}  // namespace rockslope::report_test
