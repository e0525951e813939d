#include "dda/joint/elastic.hpp"

#include <limits>

namespace rockslope::dda {

Strength Elastic::strength(const History& history, double, double, const ShearTrial&) const {
    // The strengths of Eq. (45).
    const double unbounded = std::numeric_limits<double>::infinity();
    return {unbounded, unbounded, history.bonded ? unbounded : 0};
}

}  // namespace rockslope::dda
