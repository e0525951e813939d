#include "record/differentiate.hpp"

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <limits>
#include <stdexcept>

#include "record/accelerogram.hpp"

namespace rockslope::record {

namespace {

using Spline = boost::math::interpolators::cardinal_cubic_b_spline<double>;

Spline spline_through(const Record& record) {
    if (record.values.size() < min_spline_samples)
        throw std::invalid_argument("the record has " + std::to_string(record.values.size()) +
                                    " samples; expected at least 5 to differentiate a " +
                                    quantity_name(record.quantity));
    const double estimated = std::numeric_limits<double>::quiet_NaN();
    const bool from_rest = record.quantity == Quantity::displacement;
    return {
        record.values.begin(), record.values.end(), 0.0, record.dt, from_rest ? 0.0 : estimated, estimated};
}

template <class Value>
std::vector<double> at_samples(const Record& record, const Value& value) {
    std::vector<double> result(record.values.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = value(static_cast<double>(i) * record.dt);
    return result;
}

}  // namespace

std::vector<double> acceleration_samples(const Record& record) {
    if (record.quantity == Quantity::acceleration) return record.values;
    const Spline spline = spline_through(record);
    if (record.quantity == Quantity::velocity)
        return at_samples(record, [&](double t) { return spline.prime(t); });
    return at_samples(record, [&](double t) { return spline.double_prime(t); });
}

std::vector<double> velocity_samples(const Record& record) {
    if (record.quantity == Quantity::velocity) return record.values;
    if (record.quantity == Quantity::acceleration) return integrate({record.dt, record.values}).velocity;
    const Spline spline = spline_through(record);
    return at_samples(record, [&](double t) { return spline.prime(t); });
}

}  // namespace rockslope::record
