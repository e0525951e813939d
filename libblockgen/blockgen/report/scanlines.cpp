#include "blockgen/report/scanlines.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::blockgen {

namespace {

/// What a scanline crosses, at a distance from its first point, m.
struct Crossing {
    double at = 0;
    bool is_face = false;  ///< of the rock; otherwise a joint
};

/// The crossings of the whole straight line through a scanline, in order.
std::vector<Crossing> crossings_of(const CutContext& cut, const Scanline& line) {
    const double length = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
    const Point direction{(line.to.x - line.from.x) / length, (line.to.y - line.from.y) / length};
    const auto& nodes = cut.noded.vertices;
    PerNode<double> along(nodes.size()), beside(nodes.size());
    for (const NodeIndex v : nodes.indices()) {
        const Point p = cut.noded.frame.position(nodes[v]);
        const Point arm{p.x - line.from.x, p.y - line.from.y};
        along[v] = direction.x * arm.x + direction.y * arm.y;
        beside[v] = direction.x * arm.y - direction.y * arm.x;
    }
    std::vector<Crossing> crossings;
    for (const EdgeIndex e : cut.noded.edges.indices()) {
        const auto& [a, b] = cut.noded.edges[e];
        // A node on the line counts as left of it, so a line through a node crosses each of its joints once.
        if ((beside[a] >= 0) == (beside[b] >= 0)) continue;
        const bool left = cut.is_rock(forward_half(e)), right = cut.is_rock(backward_half(e));
        if (left == right && !(left && cut.is_joint(e))) continue;
        const double part = beside[a] / (beside[a] - beside[b]);
        crossings.push_back({along[a] + part * (along[b] - along[a]), left != right});
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
    return crossings;
}

ScanlineCount count_along(const CutContext& cut, const Scanline& line) {
    const double end = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
    ScanlineCount count{.name = line.name, .sound_length = line.sound_length};
    bool inside = false;
    double begin = 0;
    const auto add_piece = [&](double until) {
        if (!inside || until <= begin) return;
        count.rock += until - begin;
        if (until - begin >= line.sound_length) count.sound += until - begin;
    };
    for (const Crossing& crossing : crossings_of(cut, line)) {
        if (crossing.at > end) break;
        add_piece(crossing.at);
        begin = std::max(crossing.at, 0.0);
        if (crossing.is_face)
            inside = !inside;
        else if (crossing.at >= 0)
            ++count.joints;
    }
    add_piece(end);
    return count;
}

}  // namespace

double ScanlineCount::random_rock_quality() const {
    if (!(rock > 0)) return 0;
    const double joints_in_piece = frequency() * sound_length;
    return 100 * std::exp(-joints_in_piece) * (1 + joints_in_piece);
}

std::vector<ScanlineCount> count_along_scanlines(const CutContext& cut) {
    std::vector<ScanlineCount> counts;
    for (const Scanline& line : cut.model.scanlines) counts.push_back(count_along(cut, line));
    return counts;
}

}  // namespace rockslope::blockgen
