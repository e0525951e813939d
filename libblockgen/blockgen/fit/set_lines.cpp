#include "blockgen/fit/set_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

namespace {

/// Directions of a set that scatter less are those of parallel lines, rounded.
constexpr double parallel_sd = 0.1 * std::numbers::pi / 180;
/// Lines of a set with less spread of their distances are evenly spaced.
constexpr double even_spread = 0.02;

Bounds bounds_of(const MapWindow& window) {
    Ring all;
    for (const Ring& ring : window.outer) all.insert(all.end(), ring.begin(), ring.end());
    return Bounds::of(all);
}

/// A frame along the mean direction of a set, about the middle of the window.
class SetFrame {
  public:
    SetFrame(const DirectionSet& direction, const MapWindow& window)
        : window_(window), u_{std::cos(direction.mean), std::sin(direction.mean)} {
        const Bounds box = bounds_of(window);
        middle_ = {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
        reach_ = std::hypot(box.high.x - box.low.x, box.high.y - box.low.y);
    }

    double across(const Point& p) const { return u_.x * (p.y - middle_.y) - u_.y * (p.x - middle_.x); }
    double along(const Point& p) const { return u_.x * (p.x - middle_.x) + u_.y * (p.y - middle_.y); }
    /// Where a piece, prolonged, crosses the line across the set.
    double crossing(const MappedPiece& piece) const {
        const double from = along(piece.a), to = along(piece.b);
        const double t = to == from ? 0 : -from / (to - from);
        return across(piece.a) + t * (across(piece.b) - across(piece.a));
    }
    /// Length within the window of the line at a distance across.
    double chord(double offset) const {
        const Point on{middle_.x - offset * u_.y, middle_.y + offset * u_.x};
        return total(stretches_within(window_, on, {on.x + u_.x, on.y + u_.y}, -reach_, reach_));
    }
    /// The window's extent on the line across the set.
    std::pair<double, double> extent() const {
        const std::vector<double> at =
            stretches_within(window_, middle_, {middle_.x - u_.y, middle_.y + u_.x}, -reach_, reach_);
        return at.empty() ? std::pair(0.0, 0.0) : std::pair(at.front(), at.back());
    }
    double reach() const { return reach_; }

  private:
    static double total(const std::vector<double>& stretches) {
        double sum = 0;
        for (std::size_t k = 0; k + 1 < stretches.size(); k += 2) sum += stretches[k + 1] - stretches[k];
        return sum;
    }

    const MapWindow& window_;
    Point u_, middle_;
    double reach_ = 0;
};

std::vector<double> differences(const std::vector<double>& sorted) {
    std::vector<double> gaps;
    for (std::size_t k = 0; k + 1 < sorted.size(); ++k) gaps.push_back(sorted[k + 1] - sorted[k]);
    return gaps;
}

double offset_of(const MappedPiece& piece, const SetFrame& frame) {
    return frame.across({(piece.a.x + piece.b.x) / 2, (piece.a.y + piece.b.y) / 2});
}

}  // namespace

SetLines own_lines(const std::vector<MappedPiece>& pieces, const DirectionSet& direction,
                   const MapWindow& window) {
    const SetFrame frame(direction, window);
    SetLines lines;
    const bool is_parallel = direction.sd <= parallel_sd;
    const auto [low, high] = frame.extent();
    std::vector<double> crossings;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const bool is_new = k == 0 || pieces[k].trace != pieces[k - 1].trace;
        if (is_new) ++lines.lines;
        lines.line_of.push_back(lines.lines - 1);
        const double c = is_parallel ? offset_of(pieces[k], frame) : frame.crossing(pieces[k]);
        if (is_new && (is_parallel || (c >= low && c <= high))) crossings.push_back(c);
    }
    lines.chord.assign(lines.lines, 0);
    std::sort(crossings.begin(), crossings.end());
    lines.gaps = differences(crossings);
    return lines;
}

SetLines common_lines(const std::vector<MappedPiece>& pieces, const DirectionSet& direction,
                      const MapWindow& window) {
    if (direction.sd > parallel_sd) return own_lines(pieces, direction, window);
    const SetFrame frame(direction, window);
    std::vector<double> offset;
    for (const MappedPiece& piece : pieces) offset.push_back(offset_of(piece, frame));
    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return offset[i] < offset[j]; });
    // Offsets along one line differ by digits, and by the error of the mean direction over the window.
    const double tolerance = 2e-3 * frame.reach() / static_cast<double>(pieces.size());
    SetLines lines;
    lines.line_of.resize(pieces.size());
    std::vector<double> places;
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (k == 0 || offset[order[k]] - offset[order[k - 1]] > tolerance) {
            places.push_back(offset[order[k]]);
            lines.chord.push_back(frame.chord(offset[order[k]]));
        }
        lines.line_of[order[k]] = places.size() - 1;
    }
    lines.lines = places.size();
    lines.gaps = differences(places);
    return lines;
}

Law law_of_gaps(const std::vector<double>& gaps) {
    const auto n = static_cast<double>(gaps.size());
    double mean = 0, square = 0, log_mean = 0, log_square = 0;
    for (const double gap : gaps) {
        const double x = std::log(std::max(gap, 1e-300));
        mean += gap / n;
        square += gap * gap / n;
        log_mean += x / n;
        log_square += x * x / n;
    }
    const double variance = std::max(square - mean * mean, 0.0);
    if (std::sqrt(variance) < even_spread * mean) return Law::constant;
    const double log_variance = std::max(log_square - log_mean * log_mean, 1e-12);
    const double exponential = -n * std::log(mean) - n;
    const double lognormal = -n * log_mean - n / 2 * std::log(2 * std::numbers::pi * log_variance) - n / 2;
    return lognormal - 1 > exponential ? Law::lognormal : Law::exponential;
}

}  // namespace rockslope::blockgen
