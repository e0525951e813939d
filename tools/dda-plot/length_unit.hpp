#pragma once

#include <string>

namespace rockslope {

/// A unit of length and its factor from metres.
struct LengthUnit {
    std::string name;
    double per_metre;
};

/// The unit for lengths of at most `largest`, m.
inline LengthUnit readable_unit(double largest) {
    if (largest < 1e-3) return {"\u00b5m", 1e6};
    if (largest < 1) return {"mm", 1e3};
    return {"m", 1};
}

}  // namespace rockslope
