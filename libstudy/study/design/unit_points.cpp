#include "study/design/unit_points.hpp"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <numeric>
#include <random>
#include <utility>

namespace rockslope::study {

namespace {

/// Draws that are the same on every platform, unlike those of the standard distributions.
class Draws {
  public:
    explicit Draws(std::uint64_t seed) : generator_(seed) {}
    /// In [0, 1).
    double unit() { return static_cast<double>(generator_() >> 11u) * 0x1p-53; }
    /// A number below `count`.
    int below(int count) { return std::min(static_cast<int>(unit() * count), count - 1); }
    /// The numbers below `count` in random order (Fisher and Yates).
    std::vector<int> permutation(int count) {
        std::vector<int> order(static_cast<std::size_t>(count));
        std::iota(order.begin(), order.end(), 0);
        for (int k = count - 1; k > 0; --k)
            std::swap(order[static_cast<std::size_t>(k)], order[static_cast<std::size_t>(below(k + 1))]);
        return order;
    }

  private:
    std::mt19937_64 generator_;
};

UnitPoints empty_points(int rows, int factors) {
    return UnitPoints(static_cast<std::size_t>(rows), std::vector<double>(static_cast<std::size_t>(factors)));
}

}  // namespace

UnitPoints monte_carlo_points(int rows, int factors, std::uint64_t seed) {
    Draws draws(seed);
    UnitPoints points = empty_points(rows, factors);
    for (std::vector<double>& point : points)
        for (double& coordinate : point) coordinate = draws.unit();
    return points;
}

UnitPoints latin_hypercube_points(int rows, int factors, std::uint64_t seed) {
    Draws draws(seed);
    UnitPoints points = empty_points(rows, factors);
    for (std::size_t factor = 0; factor < static_cast<std::size_t>(factors); ++factor) {
        const std::vector<int> order = draws.permutation(rows);
        for (std::size_t row = 0; row < points.size(); ++row)
            points[row][factor] = (order[row] + draws.unit()) / rows;
    }
    return points;
}

UnitPoints sobol_points(int rows, int factors) {
    boost::random::sobol sequence(static_cast<std::size_t>(factors));
    UnitPoints points = empty_points(rows, factors);
    for (std::vector<double>& point : points)
        for (double& coordinate : point) coordinate = static_cast<double>(sequence() >> 11u) * 0x1p-53;
    return points;
}

UnitPoints saltelli_points(int base_rows, int factors) {
    const UnitPoints both = sobol_points(base_rows, 2 * factors);
    const auto half = static_cast<std::ptrdiff_t>(factors);
    UnitPoints points;
    for (const std::vector<double>& row : both) points.emplace_back(row.begin(), row.begin() + half);
    for (const std::vector<double>& row : both) points.emplace_back(row.begin() + half, row.end());
    for (std::size_t factor = 0; factor < static_cast<std::size_t>(factors); ++factor)
        for (const std::vector<double>& row : both) {
            points.emplace_back(row.begin(), row.begin() + half);
            points.back()[factor] = row[factor + static_cast<std::size_t>(factors)];
        }
    return points;
}

UnitPoints morris_points(int trajectories, int levels, int factors, std::uint64_t seed) {
    Draws draws(seed);
    const int stride = levels / 2;
    UnitPoints points;
    for (int trajectory = 0; trajectory < trajectories; ++trajectory) {
        std::vector<int> at(static_cast<std::size_t>(factors));
        for (int& level : at) level = draws.below(levels);
        const auto add = [&] {
            std::vector<double> point;
            // The middle of the level's interval.
            for (const int level : at) point.push_back((level + 0.5) / levels);
            points.push_back(std::move(point));
        };
        add();
        for (const int factor : draws.permutation(factors)) {
            int& level = at[static_cast<std::size_t>(factor)];
            level += level < stride ? stride : -stride;
            add();
        }
    }
    return points;
}

}  // namespace rockslope::study
