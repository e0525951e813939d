#pragma once

#include "common/base/thread_pool.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The direction of an edge.
struct EdgeDirection {
    Vec2 tangent;   ///< unit, from its first corner to its second
    double length;  ///< m
};

/// The directions of all edges. @param vertices per corner, m.
inline PerEdge<EdgeDirection> edge_directions(const Topology& topology, CornerSpan<const Vec2> vertices,
                                              const ThreadPool& pool) {
    PerEdge<EdgeDirection> directions(topology.corner_count());
    pool.parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
        for (const EdgeIndex edge : indices<EdgeIndex>(begin, end)) {
            const Vec2 along = vertices[topology.end_of(edge)] - vertices[start_of(edge)];
            const double length = along.norm();
            directions[edge] = {along / length, length};
        }
    });
    return directions;
}

}  // namespace rockslope::dda
