#include "blockgen/faces/mark_edges.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

std::int32_t index_of(std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return found - names.begin();
    names.push_back(name);
    return names.size() - 1;
}

/// Joint material of an edge without a joint: that of the last region or excavation with a joint_material
/// whose outline runs along the edge, excavations after regions.
class OutlineMaterials {
  public:
    OutlineMaterials(const NodedEdges& noded, const SlopeModel& model, const SourceTable& table)
        : noded_(noded), model_(model), table_(table) {}

    const std::string& joint_material(std::size_t edge) const {
        const std::string* material = nullptr;
        const Region* region = nullptr;
        const Excavation* excavation = nullptr;
        for (const EdgeSource& s : noded_.sources_of(edge)) {  // sorted by source
            if (table_.is_region(s.source))
                note(model_.regions[s.source - table_.first_region], region, material);
            if (table_.is_excavation(s.source))
                note(model_.excavations[s.source - table_.first_excavation], excavation, material);
        }
        if (material) return *material;
        const Point p = noded_.frame.position(noded_.vertices[noded_.edges[edge].first]);
        const std::string where =
            " at (" + shortest_text(p.x) + ", " + shortest_text(p.y) + ") where no joint runs";
        if (excavation)
            throw InputError(excavation->place,
                             "the outline of excavation '" + excavation->name + "' lies in rock" + where,
                             "joint_material in its table, for the outline");
        if (region == nullptr)
            throw std::logic_error("an edge between two blocks lies on no joint and on no outline" + where);
        throw InputError(region->place, "region '" + region->name + "' separates two block materials" + where,
                         "joint_material in the [[region]]");
    }

  private:
    template <class Outline>
    static void note(const Outline& outline, const Outline*& last, const std::string*& material) {
        last = &outline;
        if (!outline.joint_material.empty()) material = &outline.joint_material;
    }

    const NodedEdges& noded_;
    const SlopeModel& model_;
    const SourceTable& table_;
};

}  // namespace

EdgeMarks mark_edges(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces,
                     const BlockBoundary& boundary, const SlopeModel& model, const std::vector<Trace>& traces,
                     const SourceTable& table) {
    const OutlineMaterials outlines(noded, model, table);
    EdgeMarks result;
    result.marks.resize(noded.edges.size());
    std::vector<std::int32_t> joint_of_edge(noded.edges.size(), EdgeMark::no_joint);
    std::vector<std::int32_t> number(traces.size(), EdgeMark::no_joint);
    const auto is_rock = [&](std::size_t h) {
        return faces.block[subdivision.face[h]] != FaceBlocks::outside;
    };
    const auto separates_blocks = [&](std::size_t e) {
        return boundary.is_boundary[e] && is_rock(2 * e) && is_rock(2 * e + 1);
    };
    for (std::size_t e = 0; e < noded.edges.size(); ++e) {
        if (!separates_blocks(e)) continue;
        for (const EdgeSource& s : noded.sources_of(e))  // sorted by source
            if (table.is_joint(s.source)) {
                joint_of_edge[e] = s.source - table.first_joint;
                number[joint_of_edge[e]] = 0;
                break;
            }
    }
    for (std::size_t t = 0; t < traces.size(); ++t) {
        if (number[t] == EdgeMark::no_joint) continue;
        number[t] = result.joints.size();
        result.joints.push_back({traces[t].name});
    }
    for (std::size_t e = 0; e < noded.edges.size(); ++e) {
        if (!separates_blocks(e)) continue;
        const std::int32_t joint = joint_of_edge[e];
        const std::string& material =
            joint == EdgeMark::no_joint ? outlines.joint_material(e) : traces[joint].joint_material;
        result.marks[e] = {index_of(result.joint_materials, material),
                           joint == EdgeMark::no_joint ? joint : number[joint]};
    }
    return result;
}

}  // namespace rockslope::blockgen
