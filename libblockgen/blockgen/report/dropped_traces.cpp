#include "blockgen/report/dropped_traces.hpp"

#include <algorithm>
#include <unordered_map>

#include "blockgen/input/trace_length.hpp"

namespace rockslope::blockgen {

namespace {

/// Where a trace runs after noding.
struct Course {
    bool in_rock = false, on_boundary = false;
};

PerJointTrace<Course> courses_of(const CutContext& cut, std::size_t given) {
    PerJointTrace<Course> courses(given);
    for (const EdgeIndex e : cut.noded.edges.indices()) {
        const bool left = cut.block_of(forward_half(e)) != FaceBlocks::outside;
        const bool right = cut.block_of(backward_half(e)) != FaceBlocks::outside;
        if (!left && !right) continue;
        for (const EdgeSource& s : cut.noded.sources_of(e)) {
            if (!cut.table.is_joint(s.source)) continue;
            const JointTraceIndex trace = cut.table.trace_of(s.source);
            if (trace >= given) break;  // sources are sorted, and given traces come first
            (left && right ? courses[trace].in_rock : courses[trace].on_boundary) = true;
        }
    }
    return courses;
}

/// Dropped traces of one name.
struct Dropped {
    std::string name;
    std::size_t points = 0, outside = 0, on_boundary = 0;

    void add_to(std::vector<std::string>& warnings) const {
        add(points, "has no length on this grid and is dropped",
            "have no length on this grid and are dropped", warnings);
        add(outside, "lies outside the rock and is dropped", "lie outside the rock and are dropped",
            warnings);
        add(on_boundary, "runs along a free face only, which stays free",
            "run along a free face only, which stays free", warnings);
    }

  private:
    void add(std::size_t count, const std::string& one, const std::string& many,
             std::vector<std::string>& warnings) const {
        if (count > 0)
            warnings.push_back(std::to_string(count) + (count == 1 ? " trace" : " traces") + " of '" + name +
                               "' " + (count == 1 ? one : many));
    }
};

}  // namespace

std::vector<std::string> dropped_trace_warnings(const CutContext& cut) {
    const std::size_t given = std::min(cut.traces.size(), cut.model.traces.size());
    std::vector<std::string> warnings;
    if (given == 0) return warnings;
    const PerJointTrace<Course> courses = courses_of(cut, given);
    std::vector<Dropped> rows;
    std::unordered_map<std::string, std::size_t> row_of_name;
    for (const JointTraceIndex t : courses.indices()) {
        if (courses[t].in_rock) continue;
        const Trace& trace = cut.traces[t];
        const auto [found, is_new] = row_of_name.emplace(trace.name, rows.size());
        if (is_new) rows.push_back({trace.name});
        Dropped& row = rows[found->second];
        if (courses[t].on_boundary)
            row.on_boundary += !cut.model.outline_of_traces;
        else
            ++(length_of(trace) < cut.noded.frame.step ? row.points : row.outside);
    }
    for (const Dropped& row : rows) row.add_to(warnings);
    return warnings;
}

}  // namespace rockslope::blockgen
