#include "dda/record/differentiate.hpp"

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <limits>
#include <stdexcept>

namespace dda {

std::vector<double> acceleration_samples(const Record& record) {
    using Spline = boost::math::interpolators::cardinal_cubic_b_spline<double>;
    if (record.quantity == Quantity::acceleration) return record.values;
    if (record.values.size() < least_differentiable)
        throw std::invalid_argument("the record has " + std::to_string(record.values.size()) +
                                    " samples; expected at least 5 to differentiate a " +
                                    quantity_name(record.quantity));
    const double estimated = std::numeric_limits<double>::quiet_NaN();
    const bool from_rest = record.quantity == Quantity::displacement;
    const Spline spline(record.values.begin(), record.values.end(), 0.0, record.dt,
                        from_rest ? 0.0 : estimated, estimated);
    std::vector<double> result(record.values.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double time = static_cast<double>(i) * record.dt;
        result[i] = from_rest ? spline.double_prime(time) : spline.prime(time);
    }
    return result;
}

}  // namespace dda
