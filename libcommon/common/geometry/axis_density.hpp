#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/geometry/space_direction.hpp"

namespace rockslope {

/// Density of axes, which are directions without a sign, on the hemisphere: by Kamb's method (1959) with the
/// exponential kernel of Vollmer (1995). With n axes p_i
///
///     density(x) = k / (n (1 - exp(-k))) sum of exp(k (|x.p_i| - 1)),   k = 2 (1 + n / 9).
///
/// It is in multiples of that of uniform axes, which is the same as in % of the axes for each % of the
/// hemisphere's area. Its mean over the hemisphere is 1 exactly. At this k the expected weight of n uniform
/// axes is three times its standard deviation. k is at most 500, a kernel of 2.6 deg: compass readings are
/// no better. Axes nearer to each other than about 0.5 deg are taken at their mean.
class AxisDensity {
  public:
    /// @param axes one or more.
    explicit AxisDensity(std::span<const SpaceDirection> axes);

    /// The density at a direction, of either sign.
    double at(const SpaceDirection& direction) const;
    /// Standard deviation of the density at any place for as many axes drawn uniformly:
    /// sqrt((k / 2 coth(k / 2) - 1) / n), which is 1/3 for many axes.
    double uniform_deviation() const;
    /// Number of axes.
    std::size_t count() const { return count_; }

    /// A place of largest density.
    struct Peak {
        SpaceDirection axis;  ///< downward
        double density = 0;
    };
    /// The largest density: from the densest axis uphill.
    Peak peak() const;

  private:
    struct Group {
        SpaceDirection axis;
        double count = 0;
    };
    /// The kernel's weight of a group at a direction, and the side of it on which the axis lies, +1 or -1.
    struct Weight {
        double value = 0, side = 1;
    };
    Weight weight_of(const Group& group, const SpaceDirection& direction) const;
    /// The mean of all axes by their weights at a direction: uphill of it.
    SpaceDirection weighted_mean(const SpaceDirection& direction) const;

    std::vector<Group> groups_;
    std::size_t count_ = 0;
    double concentration_ = 0;  ///< k
};

}  // namespace rockslope
