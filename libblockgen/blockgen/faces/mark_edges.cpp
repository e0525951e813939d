#include "blockgen/faces/mark_edges.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

std::int32_t index_of(std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::int32_t>(found - names.begin());
    names.push_back(name);
    return static_cast<std::int32_t>(names.size() - 1);
}

/// What gives an edge without a joint its material: of the regions and excavations whose outline it is on,
/// the last that names one, excavations after regions.
class Outlines {
  public:
    Outlines(const NodedEdges& noded, const SlopeModel& model, const SourceTable& table)
        : noded_(noded), model_(model), table_(table) {}

    const std::string& joint_material(std::size_t edge) const {
        const std::string* material = nullptr;
        const Region* region = nullptr;
        const Excavation* excavation = nullptr;
        for (const EdgeSource& s : noded_.sources_of(edge)) {  // sorted by source
            if (table_.is_region(s.source))
                note(model_.regions[static_cast<std::size_t>(s.source - table_.first_region)], region,
                     material);
            if (table_.is_excavation(s.source))
                note(model_.excavations[static_cast<std::size_t>(s.source - table_.first_excavation)],
                     excavation, material);
        }
        if (material) return *material;
        const Point p =
            noded_.frame.place(noded_.vertices[static_cast<std::size_t>(noded_.edges[edge].first)]);
        const std::string where =
            " at (" + shortest_text(p.x) + ", " + shortest_text(p.y) + ") where no joint runs";
        if (excavation)
            throw InputError(excavation->place,
                             "excavation '" + excavation->name + "' is cut out of the rock" + where,
                             "joint_material, for its outline, beside the stage");
        if (region == nullptr) throw std::logic_error("an edge that parts two rocks is no outline's");
        throw InputError(region->place, "region '" + region->name + "' parts two block materials" + where,
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
    const Outlines outlines(noded, model, table);
    EdgeMarks result;
    result.marks.resize(noded.edges.size());
    std::vector<std::int32_t> joint_of_edge(noded.edges.size(), EdgeMark::no_joint);
    std::vector<std::int32_t> number(traces.size(), EdgeMark::no_joint);
    const auto is_rock = [&](std::size_t h) {
        return faces.block[static_cast<std::size_t>(subdivision.face[h])] != FaceBlocks::outside;
    };
    const auto parts_blocks = [&](std::size_t e) {
        return boundary.is_boundary[e] && is_rock(2 * e) && is_rock(2 * e + 1);
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
                                          ? outlines.joint_material(e)
                                          : traces[static_cast<std::size_t>(joint)].joint_material;
        result.marks[e] = {index_of(result.joint_materials, material),
                           joint == EdgeMark::no_joint ? joint : number[static_cast<std::size_t>(joint)]};
    }
    return result;
}

}  // namespace rockslope::blockgen
