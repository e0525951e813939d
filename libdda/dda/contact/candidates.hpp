#pragma once

#include <span>
#include <vector>

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// All pairs of a corner and an edge of different blocks whose distance is at most `distance`, sorted.
/// A uniform grid makes the cost linear in the number of corners; its cell is the larger of `distance` and
/// the median edge length. Pairs of two blocks that cannot move are left out, and so are reflex corners,
/// which can touch no edge.
std::vector<CornerEdge> find_candidates(const Model& model, std::span<const Vec2> vertices, double distance);

/// The length that lengths of a model are compared with, m: the median of its edges'.
double median_edge_length(const Topology& topology, std::span<const Vec2> vertices);

/// Distance of a point from a segment, m.
double distance_to_segment(const Vec2& point, const Vec2& first, const Vec2& second);

}  // namespace rockslope::dda
