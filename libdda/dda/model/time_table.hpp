#pragma once

#include <vector>

namespace rockslope::dda {

/// A piecewise linear function of time, constant before the first and after the last entry. An empty table is
/// the constant 1, the history of a constant load.
class TimeTable {
  public:
    TimeTable() = default;
    /// @param times in s, strictly increasing; @param values one for each.
    TimeTable(std::vector<double> times, std::vector<double> values);

    /// The value at a time, s.
    double at(double time) const;
    /// Whether the table has no entries.
    bool empty() const { return times_.empty(); }
    /// The times of the entries, s.
    const std::vector<double>& times() const { return times_; }
    /// The values of the entries.
    const std::vector<double>& values() const { return values_; }

  private:
    std::vector<double> times_;
    std::vector<double> values_;
};

}  // namespace rockslope::dda
