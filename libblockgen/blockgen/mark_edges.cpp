#include "blockgen/mark_edges.hpp"

#include <algorithm>
#include <stdexcept>

#include "blockgen/base/text.hpp"

namespace blockgen {

namespace {

std::int32_t index_of(std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::int32_t>(found - names.begin());
    names.push_back(name);
    return static_cast<std::int32_t>(names.size() - 1);
}

const std::string& contact_material(const NodedEdges& noded, std::size_t edge, const SlopeModel& model,
                                    const SourceTable& table) {
    const Region* at_fault = nullptr;
    const Region* giver = nullptr;
    for (const EdgeSource& s : noded.sources_of(edge)) {
        if (!table.is_region(s.source)) continue;
        const Region& region = model.regions[static_cast<std::size_t>(s.source - table.first_region)];
        at_fault = &region;
        if (!region.joint_material.empty()) giver = &region;
    }
    if (giver) return giver->joint_material;
    const Point p = noded.frame.place(noded.vertices[static_cast<std::size_t>(noded.edges[edge].first)]);
    if (at_fault == nullptr) throw std::logic_error("an edge that parts block materials is no region's");
    throw InputError(at_fault->place,
                     "region '" + at_fault->name + "' parts two block materials at (" + shortest_text(p.x) +
                         ", " + shortest_text(p.y) + ") where no joint runs",
                     "joint_material in the [[region]]");
}

}  // namespace

EdgeMarks mark_edges(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces,
                     const BlockBoundary& boundary, const SlopeModel& model, const std::vector<Trace>& traces,
                     const SourceTable& table) {
    EdgeMarks result;
    result.marks.resize(noded.edges.size());
    std::vector<std::int32_t> joint_of_edge(noded.edges.size(), EdgeMark::no_joint);
    std::vector<std::int32_t> number(traces.size(), EdgeMark::no_joint);
    const auto is_rock = [&](std::size_t h) {
        return faces.block[static_cast<std::size_t>(subdivision.face[h])] != FaceBlocks::outside;
    };
    const auto parts_blocks = [&](std::size_t e) {
        return boundary.keeps[e] && is_rock(2 * e) && is_rock(2 * e + 1);
    };
    for (std::size_t e = 0; e < noded.edges.size(); ++e) {
        if (!parts_blocks(e)) continue;
        for (const EdgeSource& s : noded.sources_of(e))  // sorted by source
            if (table.is_joint(s.source)) {
                joint_of_edge[e] = s.source - table.first_joint;
                number[static_cast<std::size_t>(joint_of_edge[e])] = 0;
                break;
            }
    }
    for (std::size_t t = 0; t < traces.size(); ++t) {
        if (number[t] == EdgeMark::no_joint) continue;
        number[t] = static_cast<std::int32_t>(result.joints.size());
        result.joints.push_back({traces[t].name});
    }
    for (std::size_t e = 0; e < noded.edges.size(); ++e) {
        if (!parts_blocks(e)) continue;
        const std::int32_t joint = joint_of_edge[e];
        const std::string& material = joint == EdgeMark::no_joint
                                          ? contact_material(noded, e, model, table)
                                          : traces[static_cast<std::size_t>(joint)].joint_material;
        result.marks[e] = {index_of(result.joint_materials, material),
                           joint == EdgeMark::no_joint ? joint : number[static_cast<std::size_t>(joint)]};
    }
    return result;
}

}  // namespace blockgen
