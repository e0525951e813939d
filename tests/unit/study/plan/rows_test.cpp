#include "study/plan/rows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "support/error_of.hpp"

namespace rockslope::rows_test {
namespace {

using namespace study;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

class RowsTest : public ::testing::Test {
  protected:
    RowsTest() {
        fs::create_directories(folder);
        for (const char* name : {"b.csv", "a.csv"}) std::ofstream(folder / name) << "0,0\n1,1\n";
    }
    ~RowsTest() override { fs::remove_all(folder); }
    Plan plan(const std::string& text) const {
        std::ofstream(folder / "plan.toml", std::ios::trunc) << "slope = \"slope.toml\"\nrun = \"run.toml\"\n"
                                                             << text;
        return read_plan(folder / "plan.toml");
    }
    std::vector<Row> rows(const std::string& text) const { return make_rows(plan(text)); }
    std::string refused(const std::string& text) const {
        return error_of([&] { plan(text); });
    }

    fs::path folder = fs::path(::testing::TempDir()) / ("rows_" + std::to_string(::getpid()));
};

const std::string two_factors = R"([[factor]]
name = "seed"
key = "slope:seed"
range = { from = 1, to = 3 }
[[factor]]
name = "record"
key = "run:stage[1].base_motion.x.file"
files = "*.csv"
)";
const std::string friction = R"([[factor]]
name = "friction"
key = "run:joint_material.bedding.friction_angle"
unit = "deg"
distribution = { law = "uniform", min = 20, max = 40 }
)";

TEST_F(RowsTest, AFullDesignHasAllCombinations) {
    const auto all = rows(two_factors);
    ASSERT_EQ(all.size(), 6u);
    EXPECT_THAT(all[0].values, ElementsAre("1", "a.csv"));
    EXPECT_THAT(all[1].values, ElementsAre("1", "b.csv"));
    EXPECT_THAT(all[5].values, ElementsAre("3", "b.csv"));
    const auto repeated = rows("replicates = 2\n" + two_factors);
    ASSERT_EQ(repeated.size(), 12u);
    EXPECT_EQ(repeated[1].replicate, 1);
    EXPECT_EQ(repeated[1].values, repeated[0].values);
}

TEST_F(RowsTest, PairedFactorsGoTogether) {
    const std::string pair = R"([[factor]]
name = "scale"
pair = "record"
key = "run:stage[1].base_motion.x.scale"
values = [1.5, 2]
)";
    const auto all = rows(two_factors + pair);
    ASSERT_EQ(all.size(), 6u);
    EXPECT_THAT(all[1].values, ElementsAre("1", "b.csv", "2"));
    EXPECT_THAT(refused(two_factors + pair + "unit = 3\n"), HasSubstr("unit"));
    EXPECT_THAT(
        refused("[[factor]]\nname = \"a\"\nkey = \"run:a\"\nvalues = [1]\n[[factor]]\nname = \"b\"\nkey = "
                "\"run:b\"\nvalues = [1, 2]\npair = \"a\"\n"),
        HasSubstr("'b' has 2 values, 'a' has 1"));
}

TEST_F(RowsTest, SampledDesignsDrawFromDistributions) {
    for (const char* kind : {"latin-hypercube", "sobol", "monte-carlo"}) {
        const auto all =
            rows(std::string("[design]\nkind = \"") + kind + "\"\nsamples = 16\n" + friction + two_factors);
        ASSERT_EQ(all.size(), 16u) << kind;
        std::set<std::string> angles, seeds;
        for (const Row& row : all) {
            EXPECT_THAT(row.values[0], HasSubstr(" deg\""));
            EXPECT_GE(std::atof(row.values[0].c_str() + 1), 20);
            EXPECT_LE(std::atof(row.values[0].c_str() + 1), 40);
            angles.insert(row.values[0]);
            seeds.insert(row.values[1]);
        }
        EXPECT_EQ(angles.size(), 16u) << kind;
        EXPECT_EQ(seeds.size(), 3u) << kind;
    }
    EXPECT_THAT(refused(friction), HasSubstr("is a distribution, which this design does not draw from"));
}

TEST_F(RowsTest, DesignsOfSensitivityMarkTheirBlocks) {
    const auto indices =
        rows("[design]\nkind = \"sobol\"\nsamples = 4\nindices = true\n" + friction + two_factors);
    ASSERT_EQ(indices.size(), 4u * 5);
    EXPECT_EQ(indices[0].block, "A");
    EXPECT_EQ(indices[5].block, "B");
    EXPECT_EQ(indices[8].block, "friction");
    EXPECT_EQ(indices[19].block, "record");
    EXPECT_EQ(indices[19].place, 3);
    const auto morris = rows("[design]\nkind = \"morris\"\ntrajectories = 3\n" + friction + two_factors);
    ASSERT_EQ(morris.size(), 3u * 4);
    EXPECT_EQ(morris[4].block, "2");
    const auto alone = rows("[design]\nkind = \"one-at-a-time\"\n" + friction + two_factors);
    ASSERT_EQ(alone.size(), 1u + 2 * 3);
    EXPECT_THAT(alone[0].values, ElementsAre("\"30 deg\"", "2", "b.csv"));
    EXPECT_THAT(alone[1].values, ElementsAre("\"21 deg\"", "2", "b.csv")) << "the 5 % quantile";
    EXPECT_THAT(alone[4].values, ElementsAre("\"30 deg\"", "3", "b.csv"));
}

TEST_F(RowsTest, IncrementalRowsFollowEachOther) {
    const std::string text = R"([design]
kind = "incremental"
intensity = "PGA"
measure = "crest"
limit = 0.1
[[factor]]
name = "record"
key = "run:stage[1].base_motion.x.file"
files = "*.csv"
[[factor]]
name = "PGA"
scale = "PGA"
record = "record"
values = ["0.1 g", "0.2 g", "0.3 g"]
[[measure]]
name = "crest"
point = "crest"
)";
    const auto all = rows("replicates = 2\n" + text);
    ASSERT_EQ(all.size(), 12u);
    EXPECT_EQ(all[4].block, "1");
    EXPECT_EQ(all[4].place, 2);
    EXPECT_EQ(all[7].block, "2");
    EXPECT_EQ(all[7].place, 0);
    for (std::size_t k = 0; k < 12; ++k)
        EXPECT_EQ(all[k].previous, k % 6 < 2 ? -1 : static_cast<int>(k) - 2) << k;
    EXPECT_EQ(plan(text).factors[1].targets[0].key, "stage[1].base_motion.x.scale");
    EXPECT_NEAR(plan(text).factors[1].intensities[1], 0.2 * 9.80665, 1e-12);
}

TEST_F(RowsTest, RangesHaveTheirValues) {
    const auto values = [&](const std::string& range, const std::string& unit = "") {
        return plan("[[factor]]\nname = \"x\"\nkey = \"run:x\"\n" + unit + "range = " + range + "\n")
            .factors[0]
            .values;
    };
    EXPECT_THAT(values("{ from = 1, to = 3 }"), ElementsAre("1", "2", "3"));
    EXPECT_THAT(values("{ from = 0.5, to = 1, step = 0.25 }"), ElementsAre("0.5", "0.75", "1.0"));
    EXPECT_THAT(values("{ from = 20, to = 40, count = 3 }", "unit = \"deg\"\n"),
                ElementsAre("\"20 deg\"", "\"30 deg\"", "\"40 deg\""));
    EXPECT_THAT(refused("[[factor]]\nname = \"x\"\nkey = \"run:x\"\nrange = { from = 2, to = 1 }\n"),
                HasSubstr("plan.toml:6:"));
}

TEST_F(RowsTest, RefusesPlansThatCannotBe) {
    EXPECT_THAT(refused("replicates = 0\n"), HasSubstr("a whole number from 1"));
    EXPECT_THAT(refused("blocks = \"a\"\n"), HasSubstr("'slope' and 'blocks'"));
    EXPECT_THAT(refused("[design]\nkind = \"sobol\"\n"), HasSubstr("samples"));
    EXPECT_THAT(refused("[design]\nkind = \"morris\"\nlevels = 3\n"), HasSubstr("'levels' is odd"));
    EXPECT_THAT(refused("[[measure]]\nname = \"v\"\nkind = \"moved-volume\"\n"), HasSubstr("limit"));
    EXPECT_THAT(refused("[[measure]]\nname = \"v\"\nkind = \"surface\"\n"), HasSubstr("'x'"));
    EXPECT_THAT(refused("[[measure]]\nname = \"v\"\nkind = \"deposit-height\"\n"), HasSubstr("'width'"));
    EXPECT_THAT(refused("[profile]\ninterval = 1\n"), HasSubstr("limit"));
    EXPECT_THAT(refused("[profile]\ninterval = 0\nlimit = 1\n"), HasSubstr("a positive number"));
    EXPECT_THAT(refused("[[measure]]\nname = \"v\"\nlimit = 1\n"), HasSubstr("unknown key 'limit'"));
    EXPECT_THAT(refused(two_factors + two_factors), HasSubstr("two factors 'seed'"));
}

}  // namespace
}  // namespace rockslope::rows_test
