#include "record/envelope.hpp"

#include <cmath>
#include <stdexcept>

namespace rockslope::record {

double Envelope::at(double time) const {
    if (time < 0) {
        return 0;
    }
    if (time < rise) {
        return (time / rise) * (time / rise);
    }
    const double after = time - rise - strong;
    return after < 0 ? 1.0 : std::exp(-decay * after);
}

Envelope envelope_of_earthquake(double magnitude, double distance_km) {
    if (!(magnitude >= 4 && magnitude <= 8.5)) {
        throw std::invalid_argument("magnitude must be between 4 and 8.5");
    }
    if (!(distance_km >= 0 && distance_km <= 300)) {
        throw std::invalid_argument("distance must be between 0 and 300 km");
    }
    const double moment = std::pow(10.0, 1.5 * magnitude + 16.05);
    const double corner_frequency = 4.9e6 * 3.5 * std::cbrt(100.0 / moment);
    const double strong = 1 / corner_frequency + 0.05 * distance_km;
    return {strong / 3, strong, std::log(20.0) / (2 * strong)};
}

}  // namespace rockslope::record
