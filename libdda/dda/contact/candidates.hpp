#pragma once

#include <vector>

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// All pairs of a corner and an edge of different blocks that are at most `distance` apart, sorted. Pairs of
/// two blocks without unknowns (fixed or prescribed) and removed blocks are left out. Reflex corners are left
/// out, too: their neighbours touch first. The cost is linear in the number of corners: edges are entered
/// into a uniform grid whose cell size is the larger of `distance` and the median edge length.
/// @param vertices per corner, m. @param distance m.
std::vector<CornerEdge> find_candidates(const Model& model, CornerSpan<const Vec2> vertices, double distance);

/// Median length of all edges, m: the model's reference length.
double median_edge_length(const Topology& topology, CornerSpan<const Vec2> vertices);

/// Distance of a point from a segment, m.
double distance_to_segment(const Vec2& point, const Vec2& first, const Vec2& second);

/// Whether a point is within a distance, m, of a segment.
bool is_within(double distance, const Vec2& point, const Vec2& first, const Vec2& second);

}  // namespace rockslope::dda
