#include "blockgen/faces/mark_edges.hpp"

#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

/// Numbers the joint materials in the order in which they are met.
class MaterialNumbers {
  public:
    JointMaterialIndex of(const std::string& name) {
        const auto [found, is_new] = number_.try_emplace(name, names.size());
        if (is_new) names.push_back(name);
        return found->second;
    }

    PerJointMaterial<std::string> names;

  private:
    std::unordered_map<std::string, JointMaterialIndex> number_;
};

/// Joint material of an edge without a joint: that of the last region or excavation with a joint_material
/// whose outline runs along the edge, excavations after regions.
class OutlineMaterials {
  public:
    explicit OutlineMaterials(const CutContext& cut)
        : noded_(cut.noded), model_(cut.model), table_(cut.table) {}

    const std::string& joint_material(EdgeIndex edge) const {
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
        throw InputError(
            region->place,
            std::string(region->kind) + " '" + region->name + "' separates two block materials" + where,
            std::string("joint_material in the table of the ") + region->kind);
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

EdgeMarks mark_edges(const CutContext& cut, const BlockBoundary& boundary) {
    const NodedEdges& noded = cut.noded;
    const std::vector<Trace>& traces = cut.traces;
    const OutlineMaterials outlines(cut);
    EdgeMarks result;
    result.marks.resize(noded.edges.size());
    PerEdge<JointTraceIndex> trace_of_edge(noded.edges.size(), JointTraceIndex::none());
    PerJointTrace<JointIndex> joint_of_trace(traces.size(), JointIndex::none());
    const auto is_rock = [&](HalfEdgeIndex h) { return cut.block_of(h) != FaceBlocks::outside; };
    const auto separates_blocks = [&](EdgeIndex e) {
        return boundary.is_boundary[e] && is_rock(forward_half(e)) && is_rock(backward_half(e));
    };
    for (const EdgeIndex e : noded.edges.indices()) {
        if (!separates_blocks(e)) continue;
        for (const EdgeSource& s : noded.sources_of(e))  // sorted by source
            if (cut.table.is_joint(s.source)) {
                trace_of_edge[e] = cut.table.trace_of(s.source);
                joint_of_trace[trace_of_edge[e]] = 0;
                break;
            }
    }
    for (const JointTraceIndex t : joint_of_trace.indices()) {
        if (!joint_of_trace[t].exists()) continue;
        joint_of_trace[t] = result.joints.size();
        result.joints.push_back({traces[t].name});
    }
    MaterialNumbers materials;
    PerJointTrace<JointMaterialIndex> material_of_trace(traces.size(), JointMaterialIndex::none());
    for (const EdgeIndex e : noded.edges.indices()) {
        if (!separates_blocks(e)) continue;
        const JointTraceIndex trace = trace_of_edge[e];
        if (!trace.exists()) {
            result.marks[e] = {materials.of(outlines.joint_material(e)), JointIndex::none()};
            continue;
        }
        JointMaterialIndex& material = material_of_trace[trace];
        if (!material.exists()) material = materials.of(traces[trace].joint_material);
        result.marks[e] = {material, joint_of_trace[trace]};
    }
    result.joint_materials = std::move(materials.names);
    return result;
}

}  // namespace rockslope::blockgen
