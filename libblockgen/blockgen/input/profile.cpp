#include "blockgen/input/profile.hpp"

#include <utility>

#include "common/base/text.hpp"
#include "common/geometry/segment.hpp"

namespace rockslope::blockgen {

namespace {

constexpr const char* from_left_to_right =
    "points from left to right; a ground that overhangs needs an outline";

/// The height of a piece of the profile at an x between its ends.
double height_at(const Point& a, const Point& b, double x) {
    return a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x));
}

}  // namespace

std::optional<ProfileFault> find_profile_fault(std::span<const Point> profile) {
    if (profile.size() < 2)
        return ProfileFault{0,
                            std::to_string(profile.size()) +
                                (profile.size() == 1 ? " point is no profile" : " points are no profile"),
                            "two points or more"};
    for (std::size_t k = 1; k < profile.size(); ++k) {
        const Point &before = profile[k - 1], &p = profile[k];
        if (p == before)
            return ProfileFault{k, "the profile repeats the point at x = " + shortest_text(p.x),
                                "each point once"};
        if (p.x < before.x)
            return ProfileFault{k,
                                "the profile runs backwards, from x = " + shortest_text(before.x) + " to " +
                                    shortest_text(p.x),
                                from_left_to_right};
        const bool steps_on = k > 1 && p.x == before.x && before.x == profile[k - 2].x;
        if (steps_on && (p.y > before.y) != (before.y > profile[k - 2].y))
            return ProfileFault{
                k, "the profile turns back over itself in the vertical step at x = " + shortest_text(p.x),
                from_left_to_right};
    }
    if (profile.front().x == profile.back().x)
        return ProfileFault{
            0, "the profile has no width: all its points are at x = " + shortest_text(profile[0].x),
            from_left_to_right};
    return std::nullopt;
}

std::vector<Point> simplified(std::span<const Point> line, double tolerance) {
    if (line.size() < 3) return {line.begin(), line.end()};
    std::vector<char> is_kept(line.size(), 0);
    is_kept.front() = is_kept.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> pieces = {{0, line.size() - 1}};
    while (!pieces.empty()) {
        const auto [first, last] = pieces.back();
        pieces.pop_back();
        std::size_t farthest = first;
        double most = tolerance;
        for (std::size_t k = first + 1; k < last; ++k) {
            const double distance = distance_to_segment(line[k], line[first], line[last]);
            if (distance > most) most = distance, farthest = k;
        }
        if (farthest == first) continue;
        is_kept[farthest] = 1;
        pieces.emplace_back(first, farthest);
        pieces.emplace_back(farthest, last);
    }
    std::vector<Point> kept;
    for (std::size_t k = 0; k < line.size(); ++k)
        if (is_kept[k]) kept.push_back(line[k]);
    return kept;
}

std::vector<Point> clipped_profile(std::span<const Point> profile, double low, double high) {
    std::vector<Point> part;
    for (std::size_t k = 0; k < profile.size(); ++k) {
        const Point& p = profile[k];
        if (k > 0 && profile[k - 1].x < low && p.x > low)
            part.push_back({low, height_at(profile[k - 1], p, low)});
        if (k > 0 && profile[k - 1].x < high && p.x > high)
            part.push_back({high, height_at(profile[k - 1], p, high)});
        if (p.x >= low && p.x <= high) part.push_back(p);
    }
    return part;
}

}  // namespace rockslope::blockgen
