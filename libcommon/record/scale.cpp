#include "record/scale.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "record/measures.hpp"
#include "record/response_spectrum.hpp"

namespace rockslope::record {

namespace {

double ratio(double target, double current, const std::string& name) {
    if (!(target > 0) || !std::isfinite(target)) throw std::invalid_argument(name + " must be positive");
    if (!(current > 0)) throw std::invalid_argument("a record without motion has no " + name + " to scale");
    return target / current;
}

}  // namespace

Accelerogram scaled(const Accelerogram& record, double factor) {
    if (!std::isfinite(factor)) throw std::invalid_argument("factor must be finite");
    Accelerogram result = record;
    for (double& value : result.values) value *= factor;
    return result;
}

Accelerogram scaled_to_peak(const Accelerogram& record, double peak) {
    return scaled(record, ratio(peak, largest_magnitude(record.values), "peak"));
}

Accelerogram scaled_to_arias(const Accelerogram& record, double intensity) {
    return scaled(record, std::sqrt(ratio(intensity, measure(record).arias_intensity, "Arias intensity")));
}

Accelerogram scaled_to_ordinate(const Accelerogram& record, double period, double damping,
                                double acceleration) {
    const std::array periods = {period};
    const double current = response_spectrum(record, periods, damping).front().absolute_acceleration;
    return scaled(record, ratio(acceleration, current, "spectral ordinate"));
}

}  // namespace rockslope::record
