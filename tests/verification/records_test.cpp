// Readers of records: a small file in each provider's format with ten known values. The licences of the
// original records do not allow copies in this repository; a unit test reads them where they are available.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "record/records.hpp"
#include "support/record.hpp"
#include "unit/record/small_records.hpp"

namespace rockslope::records_test {
namespace {

using namespace verification;

double peak_of(const record::Record& record) {
    return *std::max_element(record.values.begin(), record.values.end(),
                             [](double a, double b) { return std::abs(a) < std::abs(b); });
}

/// The value of largest magnitude in each file, m/s2: -5.659 times g, cm/s2 or mm/s2; for K-NET ten counts of
/// 3.92 gal.
double expected_peak(const std::string& format) {
    if (format == "knet") return 100 * 3.92e-2;
    if (format == "peer") return -5.659 * 9.80665;
    if (format == "sac") return -5.659;
    return format == "geonet" ? -5.659e-3 : -5.659e-2;
}

// V52. Number of samples, interval and peak, to 1e-6; SAC and SMC carry fewer digits than doubles.
TEST(RecordReaders, ReturnSamplesIntervalAndPeak) {
    for (const small_records::SmallRecord& small : small_records::all()) {
        const std::string format = small.format;
        record::RecordDeclaration declaration;
        if (format == "sac") declaration = {record::Quantity::acceleration, "m/s2"};
        const record::Record record = record::parse_record(small.text, format, declaration);
        const Case reader("V52", "ten samples, " + format, "required");
        reader.expect("samples", "", static_cast<double>(record.values.size()), 10, absolute(0));
        reader.expect("interval", "s", record.dt, format == "knet" ? 0.01 : 0.02, relative(1e-6));
        reader.expect("peak", "m/s²", peak_of(record), expected_peak(format), relative(1e-6));
    }
}

}  // namespace
}  // namespace rockslope::records_test
