#include "blockgen/report/repeated_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "blockgen/input/trace_length.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

/// The pieces of a joint along earlier ones.
struct SharedLine {
    double length = 0;   ///< m
    Point first_moment;  ///< m2: the sum of the pieces' middles times their lengths
    JointTraceIndex earlier;

    void add(const Point& a, const Point& b) {
        const double piece = std::hypot(b.x - a.x, b.y - a.y);
        length += piece;
        first_moment.x += piece * (a.x + b.x) / 2;
        first_moment.y += piece * (a.y + b.y) / 2;
    }
};

std::map<JointTraceIndex, SharedLine> shared_lines_of(const CutContext& cut) {
    std::map<JointTraceIndex, SharedLine> lines;
    for (const EdgeIndex e : cut.noded.edges.indices()) {
        const auto sources = cut.noded.sources_of(e);
        if (sources.size() < 2 || !cut.is_rock(forward_half(e)) || !cut.is_rock(backward_half(e))) continue;
        JointTraceIndex first = JointTraceIndex::none(), last = first;
        for (const EdgeSource& s : sources) {  // sorted by source
            if (!cut.table.is_joint(s.source) || cut.table.trace_of(s.source) == last) continue;
            last = cut.table.trace_of(s.source);
            if (!first.exists()) {
                first = last;
                continue;
            }
            SharedLine& shared = lines.try_emplace(last, SharedLine{0, {}, first}).first->second;
            shared.add(cut.noded.frame.position(cut.noded.vertices[cut.noded.edges[e].first]),
                       cut.noded.frame.position(cut.noded.vertices[cut.noded.edges[e].second]));
        }
    }
    return lines;
}

}  // namespace

std::vector<Change> repeated_joints(const CutContext& cut) {
    constexpr double least_repeated_share = 0.01;
    std::vector<Change> changes;
    for (const auto& [joint, shared] : shared_lines_of(cut)) {
        if (shared.length < least_repeated_share * length_of(cut.traces[joint])) continue;
        const Point middle{shared.first_moment.x / shared.length, shared.first_moment.y / shared.length};
        changes.push_back({ChangeKind::joint_repeated, middle, 0, shared.length, cut.traces[joint].name,
                           cut.traces[shared.earlier].name});
    }
    return changes;
}

std::vector<std::string> repeated_joint_warnings(const std::vector<Change>& changes) {
    struct Row {
        std::size_t joints = 0;
        double length = 0;
        Point first;
    };
    std::map<std::pair<std::string, std::string>, Row> rows;
    for (const Change& c : changes) {
        Row& row = rows.try_emplace({c.joint, c.other}, Row{0, 0, c.at}).first->second;
        ++row.joints;
        row.length += c.length;
    }
    std::vector<std::string> warnings;
    for (const auto& [names, row] : rows) {
        char length[32];
        std::snprintf(length, sizeof length, "%.3g", row.length);
        warnings.push_back(std::to_string(row.joints) + (row.joints == 1 ? " joint" : " joints") + " of '" +
                           names.first + "' " + (row.joints == 1 ? "runs" : "run") + " along earlier ones" +
                           (names.second == names.first ? "" : " of '" + names.second + "'") + " for " +
                           length + " m, counted once, the first at " + text_of(row.first));
    }
    return warnings;
}

}  // namespace rockslope::blockgen
