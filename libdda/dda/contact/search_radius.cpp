#include "dda/contact/search_radius.hpp"

#include <cmath>

namespace rockslope::dda {

SearchRadius initial_search_radius(ContactSpan<const Contact> contacts, const ExpectedMotion& expected) {
    double largest_penetration = 0;
    double largest_dilation = 0;
    for (const Contact& c : contacts) {
        if (c.state != ContactState::open) largest_penetration = std::max(largest_penetration, -c.gap);
        largest_dilation = std::max(largest_dilation, std::abs(c.dilation));
    }
    const double touching = 4 * largest_penetration + 2 * largest_dilation + expected.rounding;
    // Two corners move towards each other.
    const double approach_limit = 2 * expected.limit;
    return {touching + std::min(expected.change, approach_limit), expected.motion, touching + approach_limit};
}

}  // namespace rockslope::dda
