#pragma once

#include <string>

namespace rockslope {

/// The unit in which a length of at most `largest` metres reads well, and the factor from metres.
struct LengthUnit {
    std::string name;
    double per_metre;
};

inline LengthUnit readable_unit(double largest) {
    if (largest < 1e-3) return {"\u00b5m", 1e6};
    if (largest < 1) return {"mm", 1e3};
    return {"m", 1};
}

}  // namespace rockslope
