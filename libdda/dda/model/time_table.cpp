#include "dda/model/time_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace rockslope::dda {

TimeTable::TimeTable(std::vector<double> times, std::vector<double> values)
    : times_(std::move(times)), values_(std::move(values)) {
    if (times_.size() != values_.size())
        throw std::invalid_argument("a time table needs one value for each time");
    if (std::adjacent_find(times_.begin(), times_.end(), [](double a, double b) { return !(a < b); }) !=
        times_.end()) {
        throw std::invalid_argument("the times of a time table must increase");
    }
}

double TimeTable::at(double time) const {
    if (times_.empty()) return 1;
    if (time <= times_.front()) return values_.front();
    if (time >= times_.back()) return values_.back();
    const auto upper = std::upper_bound(times_.begin(), times_.end(), time);
    const auto k = static_cast<std::size_t>(upper - times_.begin());
    const double fraction = (time - times_[k - 1]) / (times_[k] - times_[k - 1]);
    return values_[k - 1] + fraction * (values_[k] - values_[k - 1]);
}

}  // namespace rockslope::dda
