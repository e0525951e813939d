// The direct shear test with blocks, compared with every row of reference curves computed by others with the
// same law.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "support/external_data.hpp"
#include "support/record.hpp"
#include "support/shear_box.hpp"

namespace rockslope::shear_rows_test {
namespace {

using namespace scene;
using namespace verification;
using Reading = ShearBox::Reading;

/// A row of a curve: displacement (mm), stress (MPa), dilation (mm).
std::vector<Reading> read_curve(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::vector<Reading> rows;
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        Reading row;
        char comma;
        if (!(fields >> row.displacement >> comma >> row.stress >> comma >> row.dilation)) continue;
        rows.push_back({row.displacement * 1e-3, row.stress * 1e6, row.dilation * 1e-3});
    }
    return rows;
}

/// The results of the blocks on one leg of the path, in order of displacement.
class Leg {
  public:
    void take(const Reading& reading) { readings_.push_back(reading); }
    void finish() {
        std::sort(readings_.begin(), readings_.end(),
                  [](const Reading& a, const Reading& b) { return a.displacement < b.displacement; });
    }
    /// Linear interpolation between steps, constant beyond the ends.
    Reading at(double displacement) const {
        const auto after = std::lower_bound(
            readings_.begin(), readings_.end(), displacement,
            [](const Reading& reading, double where) { return reading.displacement < where; });
        if (after == readings_.begin()) return *after;
        if (after == readings_.end()) return readings_.back();
        const Reading& a = *(after - 1);
        const double fraction = (displacement - a.displacement) / (after->displacement - a.displacement);
        return {displacement, a.stress + fraction * (after->stress - a.stress),
                a.dilation + fraction * (after->dilation - a.dilation)};
    }

  private:
    std::vector<Reading> readings_;
};

struct Curve {
    const char* name;
    ShearedRock rock;
};

class ShearedBlocks : public testing::TestWithParam<Curve> {};

// V37, row by row. The bound jumps at the origin, and the state of the shear spring there depends on the
// step. Rows nearer to the origin than a fiftieth of the peak displacement are not compared in stress, as the
// authors of the curves advise.
TEST_P(ShearedBlocks, FollowAllRowsOfTheCurve) {
    const auto& [name, rock] = GetParam();
    const auto folder = external_data("reference");
    if (!folder) GTEST_SKIP() << external_data_missing("reference");
    const std::vector<Reading> rows = read_curve(*folder / (std::string(name) + "_A15mm_cont.csv"));
    ASSERT_GT(rows.size(), 1000u);

    ShearBox box(rock);
    ASSERT_TRUE(box.settled());
    std::vector<Leg> legs;
    for (const double way : {15e-3, -30e-3, 30e-3, -30e-3, 15e-3}) {
        Leg& leg = legs.emplace_back();
        leg.take(box.reading());
        const dda::RunOutcome outcome =
            box.go(way, rock.law.peak_displacement / 250, [&](const Reading& reading) { leg.take(reading); });
        ASSERT_EQ(outcome.status, dda::RunStatus::completed) << outcome.message;
        leg.finish();
    }

    double stress = 0, dilation = 0;
    std::size_t leg = 0;
    for (std::size_t k = 1; k < rows.size(); ++k) {
        const bool turned = k > 1 && (rows[k].displacement - rows[k - 1].displacement) *
                                             (rows[k - 1].displacement - rows[k - 2].displacement) <
                                         0;
        if (turned) ++leg;
        ASSERT_LT(leg, legs.size());
        const Reading blocks = legs[leg].at(rows[k].displacement);
        dilation = std::max(dilation, std::abs(blocks.dilation - rows[k].dilation));
        if (std::abs(rows[k].displacement) > rock.law.peak_displacement / 50)
            stress = std::max(stress, std::abs(blocks.stress - rows[k].stress));
    }
    EXPECT_EQ(leg, 4u);
    EXPECT_LT(stress, 5e-3 * rock.strength) << "required: 0.5 % of the peak";
    EXPECT_LT(dilation, 5e-6) << "required: 5 um";
}

INSTANTIATE_TEST_SUITE_P(Rocks, ShearedBlocks,
                         testing::Values(Curve{"granite", sheared_granite()},
                                         Curve{"marble", sheared_marble()}),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace rockslope::shear_rows_test
