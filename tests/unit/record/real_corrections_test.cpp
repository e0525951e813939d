// Baseline corrections of raw strong-motion records, as published by the networks.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "record/correct.hpp"
#include "record/measures.hpp"
#include "record/records.hpp"
#include "support/case_name.hpp"
#include "support/external_data.hpp"

namespace rockslope::record::real_corrections_test {
namespace {

class RawRecords : public ::testing::TestWithParam<const char*> {
  protected:
    /// Nothing if the records are not available.
    static std::optional<Accelerogram> raw() {
        const auto folder = external_data("records");
        if (!folder) return std::nullopt;
        const Record record = read_record(*folder / GetParam(), {Quantity::acceleration});
        return Accelerogram{record.dt, record.values};
    }
    /// The time at which the Arias intensity reaches a fraction of its final value, s.
    static double time_of_arias_fraction(const Accelerogram& record, double fraction) {
        double all = 0, sum = 0;
        for (const double a : record.values) all += a * a;
        for (std::size_t k = 0; k < record.values.size(); ++k) {
            sum += record.values[k] * record.values[k];
            if (sum >= fraction * all) return static_cast<double>(k) * record.step;
        }
        return record.duration();
    }
};

// The offset of the digitiser alone makes the raw displacement drift. The corrected motion must end at rest,
// with a small permanent displacement.
TEST_P(RawRecords, EndAtRestAfterBaselineShiftCorrection) {
    const auto record = raw();
    if (!record) GTEST_SKIP() << external_data_missing("records");
    const double shift_start = time_of_arias_fraction(*record, 0.05);
    const double shift_end = time_of_arias_fraction(*record, 0.95);
    const RecordMeasures before = measure(without_mean(*record, shift_start / 2));
    const RecordMeasures after =
        measure(correct_baseline_shift(without_mean(*record, shift_start / 2), shift_start, shift_end));
    EXPECT_NEAR(after.final_velocity, 0, 1e-9 * after.peak_velocity);
    // Far from the faults the permanent displacement was centimetres at most.
    EXPECT_LT(std::abs(after.final_displacement), 0.05);
    EXPECT_NEAR(after.peak_acceleration, before.peak_acceleration, 0.01 * before.peak_acceleration);
}

// Boore's criterion for a filtered record with its padding: final values below 1 % of the peaks.
TEST_P(RawRecords, EndAtRestWhereTheyStartedWhenFiltered) {
    const auto record = raw();
    if (!record) GTEST_SKIP() << external_data_missing("records");
    const double before_event = time_of_arias_fraction(*record, 0.05) / 2;
    const RecordMeasures m = measure(high_passed(without_mean(*record, before_event), 0.1, 4));
    EXPECT_LT(std::abs(m.final_velocity), 0.01 * m.peak_velocity);
    EXPECT_LT(std::abs(m.final_displacement), 0.01 * m.peak_displacement);
}

INSTANTIATE_TEST_SUITE_P(Networks, RawRecords,
                         ::testing::Values("AOM0041801241951.EW", "AICH040010061330.EW2"),
                         [](const auto& tested) { return case_name(tested.param); });

}  // namespace
}  // namespace rockslope::record::real_corrections_test
