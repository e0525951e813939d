#pragma once

#include <string_view>
#include <vector>

namespace rockslope::dda {

class ParameterTable;

/// Mobilised over peak roughness as a function of x = displacement over peak displacement, Eq. (59): linear
/// between the entries and constant beyond them. Both are dimensionless; x starts at 0 or above and grows.
struct RoughnessTable {
    struct Entry {
        double x = 0;
        double ratio = 0;
        friend bool operator==(const Entry&, const Entry&) = default;
    };
    std::vector<Entry> entries;  ///< at least one

    /// The mobilised ratio at x, Eq. (59).
    double ratio(double x) const;
    /// The nearest entry's x above `x`, or infinity.
    double next_above(double x) const;

    /// The pairs [x, ratio] of a key. @throws InputError unless x starts at 0 or above and grows, and every
    /// ratio is from -1 to 1.
    static RoughnessTable read(const ParameterTable& table, std::string_view key);

    friend bool operator==(const RoughnessTable&, const RoughnessTable&) = default;
};

/// The mobilisation curve of Barton (1985). At its first entry the total angle is zero, because friction too
/// is mobilised from zero; the ratio of that entry is not used.
RoughnessTable barton_1985();

}  // namespace rockslope::dda
