#include "blockgen/input/repeated_traces.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unordered_set>

#include "common/geometry/orientation.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

/// Whether a line runs straight on through q, from p to r.
bool is_straight(const Point& p, const Point& q, const Point& r) {
    if (q == r) return true;
    return orientation(p, q, r) == 0 && (q.x - p.x) * (r.x - q.x) + (q.y - p.y) * (r.y - q.y) >= 0;
}

/// The corners of a trace: without vertices at which it runs straight on. Two traces along the same course
/// have the same corners, or the same in reverse.
std::vector<Point> corners_of(const std::vector<Point>& points) {
    std::vector<Point> corners;
    for (const Point& p : points) {
        while (corners.size() > 1 && is_straight(corners[corners.size() - 2], corners.back(), p))
            corners.pop_back();
        if (corners.empty() || corners.back() != p) corners.push_back(p);
    }
    return corners;
}

bool are_equal(const std::vector<Point>& a, const std::vector<Point>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end()) ||
           std::equal(a.begin(), a.end(), b.rbegin(), b.rend());
}

/// Whether two traces have the same course, in the same direction or in opposite ones.
bool are_same(const std::vector<Point>& a, const std::vector<Point>& b) {
    const auto have_ends = [&](const Point& p, const Point& q) { return a.front() == p && a.back() == q; };
    if (!have_ends(b.front(), b.back()) && !have_ends(b.back(), b.front())) return false;
    return are_equal(a, b) || are_equal(corners_of(a), corners_of(b));
}

/// A hash of a trace's ends that does not depend on its direction, for a table of a power of two.
std::size_t hash_of(const std::vector<Point>& points) {
    const auto hash = [](const Point& p) {
        // -0 equals 0.
        const std::uint64_t x = std::bit_cast<std::uint64_t>(p.x + 0.0),
                            y = std::bit_cast<std::uint64_t>(p.y + 0.0);
        std::uint64_t bits = (x ^ (x >> 32u)) * 0x9e3779b97f4a7c15u ^ (y ^ (y >> 29u)) * 0xc2b2ae3d27d4eb4fu;
        bits = (bits ^ (bits >> 31u)) * 0x94d049bb133111ebu;
        return bits ^ (bits >> 30u);
    };
    return hash(points.front()) + hash(points.back());
}

/// For each trace the earlier one that it repeats, or its own number.
std::vector<std::uint32_t> first_of_course(const std::vector<Trace>& traces) {
    constexpr std::uint32_t vacant = 0xffffffffu;
    // Open addressing in a table at most half full.
    std::vector<std::uint32_t> table(std::bit_ceil(2 * traces.size() + 2), vacant);
    std::vector<std::uint32_t> first(traces.size());
    for (std::size_t t = 0; t < traces.size(); ++t) {
        std::size_t place = hash_of(traces[t].points) & (table.size() - 1);
        while (table[place] != vacant && !are_same(traces[table[place]].points, traces[t].points))
            place = (place + 1) & (table.size() - 1);
        if (table[place] == vacant) table[place] = static_cast<std::uint32_t>(t);
        first[t] = table[place];
    }
    return first;
}

/// Traces of one name that repeat some of another one, or of their own.
struct Repeated {
    std::string name, earlier;
    Point at;  ///< the first point of the first of them
    std::size_t count = 0, of_other_material = 0;

    std::string note() const {
        std::string text = std::to_string(count) + (count == 1 ? " trace" : " traces") + " of '" + name +
                           "' " + (count == 1 ? "repeats an earlier one" : "repeat earlier ones") +
                           (earlier == name ? "" : " of '" + earlier + "'") + " and " +
                           (count == 1 ? "is" : "are") + " dropped, the first at " + text_of(at);
        if (of_other_material > 0)
            text += "; the joint material of " + (count == 1 ? "it" : std::to_string(of_other_material)) +
                    " is another one, and that of the earlier holds";
        return text;
    }
};

}  // namespace

void drop_repeated_traces(SlopeModel& model) {
    std::vector<Trace>& traces = model.traces;
    const std::vector<std::uint32_t> first = first_of_course(traces);
    std::vector<Repeated> rows;
    std::unordered_set<std::string> kept_names;
    for (std::size_t t = 0; t < traces.size(); ++t) {
        const Trace &trace = traces[t], &earlier = traces[first[t]];
        if (first[t] == t) {
            kept_names.insert(trace.name);
            continue;
        }
        auto row = std::find_if(rows.begin(), rows.end(), [&](const Repeated& r) {
            return r.name == trace.name && r.earlier == earlier.name;
        });
        if (row == rows.end()) row = rows.insert(row, {trace.name, earlier.name, trace.points.front()});
        ++row->count;
        row->of_other_material += trace.joint_material != earlier.joint_material;
    }
    if (rows.empty()) return;
    for (const Repeated& row : rows) {
        model.notes.push_back(row.note());
        if (!kept_names.contains(row.name)) model.repeated_names.push_back(row.name);
    }
    std::vector<Trace> kept;
    for (std::size_t t = 0; t < traces.size(); ++t)
        if (first[t] == t) kept.push_back(std::move(traces[t]));
    traces = std::move(kept);
}

}  // namespace rockslope::blockgen
