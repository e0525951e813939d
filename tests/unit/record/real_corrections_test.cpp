// Raw records of strong motion, as the networks give them, brought to rest.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "record/correct.hpp"
#include "record/measures.hpp"
#include "record/records.hpp"
#include "support/case_name.hpp"
#include "support/external_data.hpp"

namespace rockslope::record {
namespace {

class RawRecords : public ::testing::TestWithParam<const char*> {
  protected:
    /// Nothing where the records are not at hand.
    static std::optional<Accelerogram> raw() {
        const auto folder = external_data("records");
        if (!folder) return std::nullopt;
        const Record record = read_record(*folder / GetParam(), {Quantity::acceleration});
        return Accelerogram{record.dt, record.values};
    }
    /// The instants at which shares of the Arias intensity have passed, s.
    static double passed(const Accelerogram& record, double share) {
        double all = 0, sum = 0;
        for (const double a : record.values) all += a * a;
        for (std::size_t k = 0; k < record.values.size(); ++k) {
            sum += record.values[k] * record.values[k];
            if (sum >= share * all) return static_cast<double>(k) * record.step;
        }
        return record.duration();
    }
};

// The digitiser's offset alone makes the raw ground drift off; what is left must end at rest, where it is.
TEST_P(RawRecords, ComeToRestSomewhereFinite) {
    const auto record = raw();
    if (!record) GTEST_SKIP() << external_data_missing("records");
    const double shaken = passed(*record, 0.05), settled = passed(*record, 0.95);
    const RecordMeasures before = measure(without_mean(*record, shaken / 2));
    const RecordMeasures after =
        measure(correct_baseline_shift(without_mean(*record, shaken / 2), shaken, settled));
    EXPECT_NEAR(after.final_velocity, 0, 1e-9 * after.peak_velocity);
    // Far from their faults the ground did not move for good by more than centimetres.
    EXPECT_LT(std::abs(after.final_displacement), 0.05);
    EXPECT_NEAR(after.peak_acceleration, before.peak_acceleration, 0.01 * before.peak_acceleration);
}

// What Boore asks of a filtered record with its pads: below 1 % of the peaks.
TEST_P(RawRecords, EndAtRestWhereTheyBeganWhenFiltered) {
    const auto record = raw();
    if (!record) GTEST_SKIP() << external_data_missing("records");
    const RecordMeasures m = measure(high_passed(without_mean(*record, passed(*record, 0.05) / 2), 0.1, 4));
    EXPECT_LT(std::abs(m.final_velocity), 0.01 * m.peak_velocity);
    EXPECT_LT(std::abs(m.final_displacement), 0.01 * m.peak_displacement);
}

INSTANTIATE_TEST_SUITE_P(Networks, RawRecords,
                         ::testing::Values("AOM0041801241951.EW", "AICH040010061330.EW2"),
                         [](const auto& tested) { return case_name(tested.param); });

}  // namespace
}  // namespace rockslope::record
