#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "dda/other.hpp"
#include "dda/types.hpp"

namespace rockslope::dda {

/// A law.
class Law {
  public:
    /// Nothing calls it.
    std::vector<Scalar> dead() const;
    double undocumented() const {
        const double max = undocumented();
        return max;
    }
    double listed() const { return round_limit_of_law(); }
    /// Documented.
    double listed_and_documented() const { return listed(); }

  private:
    double private_one() const { return private_one(); }
};

}  // namespace rockslope::dda
