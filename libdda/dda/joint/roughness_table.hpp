#pragma once

#include <vector>

namespace rockslope::dda {

/// Mobilised over peak roughness as a function of x = displacement over peak displacement: linear between the
/// entries and constant beyond them. Both numbers are dimensionless; x is never negative and grows.
struct RoughnessTable {
    struct Entry {
        double x = 0;
        double ratio = 0;
        friend bool operator==(const Entry&, const Entry&) = default;
    };
    std::vector<Entry> entries;  ///< at least one

    double ratio(double x) const;
    /// The nearest entry's x beyond `x`, or infinity.
    double next_above(double x) const;
    /// The nearest entry's x below `x`, or minus infinity.
    double next_below(double x) const;

    friend bool operator==(const RoughnessTable&, const RoughnessTable&) = default;
};

/// The mobilisation curve of Barton (1985). Its first entry stands for a total angle of zero, whatever the
/// stress: friction too is mobilised from nothing. The ratio there is not used.
RoughnessTable barton_1985();

}  // namespace rockslope::dda
