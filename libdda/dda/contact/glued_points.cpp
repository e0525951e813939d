#include "dda/contact/glued_points.hpp"

#include <algorithm>
#include <cmath>

#include "dda/contact/detect.hpp"
#include "dda/model/glue.hpp"

namespace rockslope::dda {

namespace {

/// Distance below which corners are at one point in the first configuration, and length below which a contact
/// is that of a point, over the length of an edge.
constexpr double coincidence = 1e-6;

double length_of(const Model& model, EdgeIndex edge) {
    return (model.vertices[model.topology.end_of(edge)] - model.vertices[start_of(edge)]).norm();
}

/// Whether a contact is a bond of two faces that cannot break. Opposite corners of collinear faces may have a
/// bond too, of the length of their rounding.
bool is_unbreakable_bond(const Model& model, const Contact& contact) {
    return contact.bonded && contact.length > coincidence * length_of(model, contact.edge) &&
           is_glue(model.joint_material_at(contact.joint_material));
}

}  // namespace

GluedPoints::GluedPoints(const Model& model, ContactSpan<const Contact> contacts) : model_(model) {
    const Topology& topology = model.topology;
    const auto root = [&](CornerIndex corner) {
        while (point_[corner] != corner) corner = point_[corner];
        return corner;
    };
    const auto touch = [&](CornerIndex corner) {
        if (!point_[corner].exists()) point_[corner] = corner;
    };
    std::vector<const Contact*> glue;
    for (const Contact& contact : contacts) {
        if (!is_unbreakable_bond(model, contact)) continue;
        if (glue.empty()) point_.assign(topology.corner_count(), CornerIndex::none());
        glue.push_back(&contact);
        touch(contact.corner);
        const Vec2& at = model.vertices[contact.corner];
        const double distance = coincidence * length_of(model, contact.edge);
        for (const CornerIndex end : {start_of(contact.edge), topology.end_of(contact.edge)}) {
            if ((model.vertices[end] - at).norm() > distance) continue;
            touch(end);
            const CornerIndex one = root(contact.corner);
            const CornerIndex other = root(end);
            point_[std::max(one, other)] = std::min(one, other);
        }
    }
    for (const CornerIndex corner : point_.indices()) {
        if (!point_[corner].exists()) continue;
        point_[corner] = root(corner);
        blocks_.emplace_back(point_[corner], topology.block_of[corner]);
    }
    for (const Contact* contact : glue) {
        const CornerIndex point = point_[contact->corner];
        const auto [low, high] = contact->blocks();
        bonds_.push_back({point, low, high});
        blocks_.emplace_back(point, contact->edge_block);
    }
    std::sort(bonds_.begin(), bonds_.end());
    std::sort(blocks_.begin(), blocks_.end());
}

bool GluedPoints::joins(const CornerEdge& pair) const {
    if (empty() || !point_[pair.corner].exists()) return false;
    const Topology& topology = model_.topology;
    const CornerIndex point = point_[pair.corner];
    const BlockIndex block = topology.block_of_edge(pair.edge);
    if (!std::binary_search(blocks_.begin(), blocks_.end(), std::pair(point, block))) return false;
    const CornerEdgeGeometry geometry =
        corner_edge_geometry(model_.vertices[point], model_.vertices[start_of(pair.edge)],
                             model_.vertices[topology.end_of(pair.edge)]);
    const double tolerance = coincidence * geometry.length;
    if (std::abs(geometry.gap) > tolerance || geometry.end_margin() < -tolerance) return false;
    const auto [low, high] = std::minmax(topology.block_of[pair.corner], block);
    return !std::binary_search(bonds_.begin(), bonds_.end(), Bond{point, low, high});
}

void GluedPoints::remove_from(std::vector<CornerEdge>& candidates) const {
    if (empty()) return;
    std::erase_if(candidates, [&](const CornerEdge& pair) { return joins(pair); });
}

}  // namespace rockslope::dda
